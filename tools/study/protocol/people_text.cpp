#include <algorithm>

#include "proto/words/error_line.h"
#include "support/program/json.h"
#include "tools/study/figures/paper_table.h"
#include "tools/study/protocol/people_words.h"
#include "tools/study/run/parts.h"
#include "tools/study/run/trial_row.h"

namespace telepalp::study {
namespace {

std::string padded(std::string text, std::size_t width) {
  std::size_t letters = 0;
  for (const char byte : text) letters += (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U ? 1 : 0;
  text.append(letters < width ? width - letters : 1, ' ');
  return text;
}

std::string difference_in_words(const ConditionDifference& one) {
  const std::string what = one.one == Condition::Both ? "Force with sight" : "Force alone";
  const std::string figures =
      fixed_text(one.mm.mean) + " mm (" + fixed_text(one.mm.low) + " to " + fixed_text(one.mm.high) + " mm)";
  if (one.mm.low <= 0.0 && one.mm.high >= 0.0)
    return what + " makes no certain difference to sight alone: " + figures + ".";
  return what + " makes the overshoot " + (one.mm.mean < 0.0 ? "smaller" : "larger") + " than sight alone: " + figures +
         ".";
}

void add(program::Json& json, std::string_view key, const Interval& interval) {
  json.begin_object(key);
  json.add("mean_mm", interval.mean);
  json.add("low_mm", interval.low);
  json.add("high_mm", interval.high);
  json.end_object();
}

void add_people(program::Json& json, const Protocol& protocol, const PeopleResult& result) {
  json.begin_list("participants");
  for (const PersonRecord& person : result.people.records) {
    json.begin_object();
    json.add("name", person.participant.name);
    json.add("hand", words(protocol.hand));
    json.add("done", static_cast<std::uint64_t>(person.done));
    json.add("planned", static_cast<std::uint64_t>(person.planned));
    json.begin_object("plant");
    for (const Drawn<Plant>& one : plant_ranges()) json.add(one.name, person.plant.*one.value);
    json.end_object();
    json.end_object();
  }
  json.end_list();
}

void add_condition(program::Json& json, const Protocol& protocol, const PeopleCondition& one) {
  json.begin_object(name(one.condition));
  add(json, "all", one.all);
  json.add("penetrations", static_cast<std::uint64_t>(one.penetrations));
  json.add("not_through", static_cast<std::uint64_t>(one.not_through));
  json.add("not_stopped", static_cast<std::uint64_t>(one.not_stopped));
  json.add("broken_off", static_cast<std::uint64_t>(one.broken_off));
  json.add("longest_held_up_s", one.held_up_s);
  if (one.correlation) json.add("rank_correlation_with_paper", *one.correlation);
  for (std::size_t i = 0; i < one.cells.size(); ++i) add(json, protocol.design.configurations[i].name, one.cells[i]);
  json.end_object();
}

}  // namespace

std::vector<std::string> people_findings(const Protocol& protocol, const PeopleResult& result) {
  std::vector<std::string> out;
  for (const ConditionDifference& one : result.differences) out.push_back(difference_in_words(one));
  for (const PeopleCondition& one : result.conditions) {
    const auto mean = [](const Interval& cell) { return std::isfinite(cell.mean) ? cell.mean : 1e9; };
    const auto best = std::ranges::min_element(one.cells, {}, mean);
    if (best == one.cells.end() || !std::isfinite(best->mean)) continue;
    out.push_back("Least overshoot in condition " + std::string(name(one.condition)) + ": " +
                  protocol.design.configurations[static_cast<std::size_t>(best - one.cells.begin())].name + ", " +
                  in_words(*best) + " mm.");
    if (one.correlation)
      out.push_back("Its order of the 36 mechanisms agrees with S4's Table 2 by a rank correlation of " +
                    fixed_text(*one.correlation, 2) + ".");
  }
  const std::size_t people = result.people.records.size();
  const std::string who = std::to_string(people) + (people == 1 ? " participant" : " participants");
  if (people > 0 && protocol.hand == PersonHand::Browser)
    out.push_back(who +
                  " worked in a browser: force shown as a bar. A mouse gives no force, so \"force\" and \"both\" say "
                  "how well a drawn force is seen, not how well a force is felt.");
  if (people > 0 && protocol.hand == PersonHand::Device)
    out.push_back(who + " worked at a haptic device and felt the force, limited to what the device gives.");
  if (!result.finished()) out.emplace_back("The protocol is not finished: these are the figures so far.");
  return out;
}

std::string people_text(const Protocol& protocol, const PeopleResult& result) {
  constexpr std::size_t kName = 40;
  constexpr std::size_t kCell = 22;
  const auto people = result.people.records.size();
  std::string text = "overshoot past the first contact with the sac, mm; " + std::to_string(people) +
                     (people == 1 ? " person, mean of the penetrations" : " people, mean of the people") +
                     " (95 % interval)\n\n" + padded("mechanism", kName);
  for (const PeopleCondition& one : result.conditions) text += padded(std::string(name(one.condition)), kCell);
  if (protocol.design.of_the_paper) text += "S4, Table 2 (SD)";
  text += "\n";
  for (std::size_t i = 0; i < protocol.design.configurations.size(); ++i) {
    text += padded(protocol.design.configurations[i].name, kName);
    for (const PeopleCondition& one : result.conditions) text += padded(interval_or_dash(one.cells[i]), kCell);
    if (protocol.design.of_the_paper)
      text += fixed_text(paper_table()[i].overshoot_mm) + " (" + fixed_text(paper_table()[i].deviation_mm) + ")";
    text += "\n";
  }
  text += padded("all", kName);
  for (const PeopleCondition& one : result.conditions) text += padded(interval_or_dash(one.all), kCell);
  text += "\n\n";
  for (const PersonRecord& person : result.people.records)
    text += person.participant.name + ": " + std::to_string(person.done) + " of " + std::to_string(person.planned) +
            " penetrations; " + std::string(words(protocol.hand)) + "\n";
  for (const std::string& sentence : people_findings(protocol, result)) text += sentence + "\n";
  return text;
}

std::string people_json(const Protocol& protocol, const PeopleResult& result) {
  program::Json json;
  json.begin_object();
  json.add("program", "telepalp-study protocol");
  json.add("identity", identity_of(protocol));
  json.add("design", protocol.design.name);
  json.add("seed", protocol.seed);
  json.add("finished", result.finished());
  add_people(json, protocol, result);
  for (const PeopleCondition& one : result.conditions) add_condition(json, protocol, one);
  for (const ConditionDifference& one : result.differences)
    add(json, std::string(name(one.one)) + "_against_" + std::string(name(one.other)), one.mm);
  json.end_object();
  return std::move(json).finish();
}

std::string people_csv(const Protocol& protocol, const PeopleResult& result) {
  std::string hand(words(protocol.hand));
  std::ranges::replace(hand, ',', ';');
  std::vector<std::string> rows;
  for (std::size_t person = 0; person < result.people.records.size(); ++person) {
    const PersonRecord& record = result.people.records[person];
    for (const Attempt& attempt : record.attempts) {
      if (attempt.kind != AttemptKind::Formal) continue;
      Trial trial = attempt.trial;
      trial.person = person;
      rows.push_back(trial_row(trial) + "," + record.participant.name + "," + hand);
    }
  }
  return rows_text("telepalp-study protocol, " + identity_of(protocol),
                   std::string(kTrialColumns) + ",participant,hand", rows);
}

}  // namespace telepalp::study
