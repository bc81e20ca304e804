#include "tools/study/protocol/protocol.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "codec/bytes/crc32c.h"
#include "tools/study/figures/shuffle.h"
#include "tools/study/run/block_order.h"
#include "tools/study/run/seeds.h"
#include "tools/study/run/trial_row.h"

namespace telepalp::study {
namespace {

constexpr std::size_t kMostLetters = 40;
constexpr std::size_t kBeyondOperators = 1000;
constexpr std::uint32_t kNumbers = 1'000'000;
constexpr Condition kForPeople[] = {Condition::Force, Condition::Vision, Condition::Both};

Error no_condition(const std::string& what) {
  return {.what = what, .where = "--conditions", .fix = "give some of force, vision and both, such as force,both"};
}

void add_block(const Protocol& protocol, const Participant& participant, Condition condition,
               std::vector<Planned>& plan) {
  const BlockOrder order =
      block_order(protocol.seed, participant.number, condition, protocol.design.configurations.size());
  for (int i = 0; i < protocol.training; ++i) {
    const std::size_t place = static_cast<std::size_t>(i / kTrainingPenetrations) % order.training.size();
    plan.push_back({.condition = condition,
                    .training = true,
                    .place = place,
                    .configuration = order.training[place],
                    .penetration = i % kTrainingPenetrations});
  }
  for (std::size_t place = 0; place < order.formal.size(); ++place)
    for (int k = 0; k < protocol.penetrations; ++k)
      plan.push_back({.condition = condition, .place = place, .configuration = order.formal[place], .penetration = k});
}

}  // namespace

Result<Participant> participant_of(const std::string& name) {
  const bool good = !name.empty() && name.size() <= kMostLetters && std::ranges::all_of(name, [](unsigned char letter) {
    return (letter < 128 && std::isalnum(letter) != 0) || letter == '-' || letter == '_';
  });
  if (!good)
    return Error{.what = "'" + name + "' is not a short name",
                 .where = "--participant",
                 .fix = "give 1 to 40 letters, digits, - or _, such as p07; a number keeps the person unknown"};
  const std::uint32_t mixed = codec::crc32c(std::as_bytes(std::span(name)));
  return Participant{.name = name, .number = kBeyondOperators + mixed % kNumbers};
}

Result<std::vector<Condition>> read_conditions(const std::string& text) {
  std::vector<Condition> read;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.size(), text.find(',', from));
    const std::string word = text.substr(from, end - from);
    const auto* const found = std::ranges::find(kForPeople, word, [](Condition one) { return name(one); });
    if (found == std::end(kForPeople)) return no_condition("'" + word + "' is no condition of a person");
    if (std::ranges::find(read, *found) != read.end()) return no_condition("'" + word + "' is given twice");
    read.push_back(*found);
    from = end + 1;
  }
  return read;
}

std::vector<Planned> plan_of(const Protocol& protocol, const Participant& participant) {
  std::vector<Condition> conditions = protocol.conditions;
  std::ranges::sort(conditions);
  device::Random random(seed_of(protocol.seed, kConditions * 1000 + participant.number, 0));
  shuffle(std::span(conditions), random);
  std::vector<Planned> plan;
  for (const Condition condition : conditions) add_block(protocol, participant, condition, plan);
  return plan;
}

Result<Plant> plant_for(const Protocol& protocol, const Participant& participant) {
  const Plant plant = person_of({.design = {}, .seed = protocol.seed, .out = {}}, participant.number).plant;
  for (const Configuration& mechanism : protocol.design.configurations)
    if (const Result<std::unique_ptr<HeldTool>> tool = linkage_tool(mechanism, plant); !tool)
      return Error{.what = tool.error().what + ", on the plant that was drawn for " + participant.name,
                   .where = protocol.design.name,
                   .fix = tool.error().fix + ", or give another --seed"};
  return plant;
}

std::string identity_of(const Protocol& protocol) {
  std::string conditions;
  std::vector<Condition> sorted = protocol.conditions;
  std::ranges::sort(sorted);
  for (const Condition condition : sorted) conditions += (conditions.empty() ? "" : "+") + std::string(name(condition));
  return "design " + std::filesystem::path(protocol.design.name).filename().string() + ", seed " +
         std::to_string(protocol.seed) + ", conditions " + conditions + ", training " +
         std::to_string(protocol.training) + ", penetrations " + std::to_string(protocol.penetrations) +
         ", mechanisms and ranges " + std::to_string(design_checksum(protocol.design)) +
         (protocol.hand == PersonHand::Device ? ", at a haptic device" : "");
}

}  // namespace telepalp::study
