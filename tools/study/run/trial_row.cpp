#include "tools/study/run/trial_row.h"

#include <charconv>
#include <sstream>

#include "codec/bytes/crc32c.h"
#include "proto/words/error_line.h"
#include "tools/study/run/parts.h"

namespace telepalp::study {
namespace {

constexpr std::size_t kNumbers = 14;

}  // namespace

std::string trial_row(const Trial& trial) {
  const Outcome& out = trial.outcome;
  std::string row = std::to_string(trial.person + 1) + "," + std::string(name(trial.condition)) + "," +
                    std::to_string(trial.place) + "," + std::to_string(trial.configuration) + "," +
                    std::to_string(trial.penetration);
  for (const bool flag : {out.through, out.stopped, out.noticed}) row += flag ? ",1" : ",0";
  for (const double value :
       {out.overshoot_m, out.deepest_m, out.depth_at_puncture_m, out.hand_drop_N, out.most_hand_N, out.seconds})
    row += "," + number_text(value);
  return row;
}

std::optional<Trial> read_trial(const std::string& row) {
  std::istringstream cells(row);
  std::string cell;
  std::array<double, kNumbers> numbers{};
  Trial trial;
  for (std::size_t i = 0; i < kNumbers; ++i) {
    if (!std::getline(cells, cell, ',')) return std::nullopt;
    if (i == 1) {
      for (const Condition condition : kStudied)
        if (name(condition) == cell) trial.condition = condition;
      continue;
    }
    const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), numbers[i]);
    if (read.ec != std::errc{} || read.ptr != cell.data() + cell.size()) return std::nullopt;
  }
  trial.person = static_cast<std::size_t>(numbers[0]) - 1;
  trial.place = static_cast<std::size_t>(numbers[2]);
  trial.configuration = static_cast<std::size_t>(numbers[3]);
  trial.penetration = static_cast<int>(numbers[4]);
  trial.outcome = {.through = numbers[5] != 0.0,
                   .stopped = numbers[6] != 0.0,
                   .overshoot_m = numbers[8],
                   .deepest_m = numbers[9],
                   .depth_at_puncture_m = numbers[10],
                   .hand_drop_N = numbers[11],
                   .most_hand_N = numbers[12],
                   .seconds = numbers[13],
                   .noticed = numbers[7] != 0.0};
  return trial;
}

std::uint32_t design_checksum(const Design& design) {
  std::string all = ranges_text(operator_ranges()) + ranges_text(plant_ranges());
  for (const Configuration& one : design.configurations) {
    all += one.name + (one.l4_given ? "4" : "-") + (one.needle_given ? "n" : "-");
    for (const double value : {one.bar.l1_m, one.bar.l2_m, one.bar.l3_m, one.bar.l4_m, one.bar.needle_rad,
                               one.bar.needle_m, one.bar.handle_rad, one.bar.handle_at_m, one.bar.handle_m})
      all += " " + number_text(value);
    if (!one.other) continue;
    OtherMechanism other = *one.other;
    all += " " + std::string(kind_of(other));
    for (const OtherParameter& parameter : parameters_of(other)) all += " " + number_text(*parameter.value);
  }
  return codec::crc32c(std::as_bytes(std::span(all)));
}

std::string identity_of(const StudySettings& settings) {
  return program_identity(settings.seed) + ", " + std::to_string(settings.penetrations) +
         " penetrations, mechanisms and ranges " + std::to_string(design_checksum(settings.design));
}

}  // namespace telepalp::study
