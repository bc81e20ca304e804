#include "tools/study/run/experiment_run.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>

#include "codec/bytes/crc32c.h"

namespace telepalp::study {
namespace {

std::string row_text(const Row& row) {
  std::string text =
      std::to_string(row.observer + 1) + "," + std::to_string(row.condition + 1) + "," + std::to_string(row.trial + 1);
  for (const double value : row.values) text += "," + number_text(value);
  return text;
}

/// nullopt: the text is not a row with these columns.
std::optional<Row> read_row(std::string_view text, std::string_view columns) {
  std::vector<double> numbers;
  for (const char *at = text.data(), *end = at + text.size();;) {
    double number = 0.0;
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || (stop != end && *stop != ',')) return std::nullopt;
    numbers.push_back(number);
    if (stop == end) break;
    at = stop + 1;
  }
  const auto count = 1 + static_cast<std::size_t>(std::count(columns.begin(), columns.end(), ','));
  const bool is_row = numbers.size() == count &&
                      std::all_of(numbers.begin(), numbers.begin() + 3, [](double n) { return n >= 1.0 && n < 1e6; });
  if (!is_row) return std::nullopt;
  return Row{static_cast<std::size_t>(numbers[0]) - 1,
             static_cast<std::size_t>(numbers[1]) - 1,
             static_cast<int>(numbers[2]) - 1,
             {numbers.begin() + 3, numbers.end()}};
}

std::string identity_of(const Experiment& experiment, std::uint64_t seed) {
  std::string all;
  for (const RangeWords& one : experiment.ranges) all += one.name + one.range;
  return program_identity(seed) + ", " + experiment.name +
         (experiment.variant.empty() ? "" : " by " + experiment.variant) + ", ranges " +
         std::to_string(codec::crc32c(std::as_bytes(std::span(all))));
}

}  // namespace

Parts parts_of(const Experiment& experiment, const ExperimentSettings& settings) {
  Parts parts{.folder = settings.out / "runs",
              .identity = identity_of(experiment, settings.seed),
              .columns = experiment.columns,
              .count = settings.observers,
              .file = {},
              .is_whole = {},
              .make = {}};
  parts.file = [](int part) {
    char text[32];
    std::snprintf(text, sizeof text, "observer-%05d.csv", part + 1);
    return std::string(text);
  };
  parts.is_whole = [&experiment](const std::vector<std::string>& rows) {
    return !rows.empty() && std::all_of(rows.begin(), rows.end(), [&](const std::string& row) {
      const std::optional<Row> read = read_row(row, experiment.columns);
      return read && read->condition < experiment.conditions.size();
    });
  };
  parts.make = [&experiment, seed = settings.seed](int part) {
    std::vector<std::string> rows;
    for (const Row& row : experiment.run(seed, static_cast<std::size_t>(part))) rows.push_back(row_text(row));
    return rows;
  };
  return parts;
}

Result<std::vector<Row>> run_experiment(const Experiment& experiment, const ExperimentSettings& settings,
                                        const std::function<void(int)>& finished) {
  const auto parts = run_parts(parts_of(experiment, settings), settings.threads, finished);
  if (!parts) return parts.error();
  std::vector<Row> all;
  for (const std::vector<std::string>& part : *parts)
    for (const std::string& row : part) all.push_back(*read_row(row, experiment.columns));
  return all;
}

std::string rows_csv(const Experiment& experiment, const ExperimentSettings& settings, const std::vector<Row>& rows) {
  std::vector<std::string> texts;
  for (const Row& row : rows) texts.push_back(row_text(row));
  return rows_text(identity_of(experiment, settings.seed), experiment.columns, texts);
}

}  // namespace telepalp::study
