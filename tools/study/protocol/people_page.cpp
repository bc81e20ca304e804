#include <algorithm>
#include <filesystem>

#include "clients/report/figures/html.h"
#include "proto/words/error_line.h"
#include "support/plot/palette.h"
#include "support/plot/svg.h"
#include "tools/study/figures/paper_table.h"
#include "tools/study/page/overshoot_figures.h"
#include "tools/study/protocol/hands/browser_trial.h"
#include "tools/study/protocol/people_words.h"

namespace telepalp::study {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string_view color_of(Condition condition) {
  return condition == Condition::Force ? plot::kBlue : condition == Condition::Vision ? plot::kGreen : plot::kVermilion;
}

std::string overshoots(const Protocol& protocol, const PeopleResult& result) {
  plot::Chart chart = overshoot_chart(protocol.design.configurations.size());
  for (const PeopleCondition& one : result.conditions)
    add_overshoots(chart, name(one.condition), one.cells, color_of(one.condition));
  if (protocol.design.of_the_paper) add_paper(chart);
  return plot::to_svg(chart);
}

/// Each penetration in its order: what was learned on the way.
std::string learning(const PersonRecord& person) {
  plot::Chart chart{.title = person.participant.name + ": each penetration in its order",
                    .x = {.label = "number of the penetration, training included",
                          .include = plot::Range{0.0, static_cast<double>(person.done + 1)}},
                    .y = {.label = "overshoot [mm]", .include = plot::Range{0.0, 0.0}},
                    .height_px = 260.0};
  plot::Series training{
      .name = "training", .x = {}, .y = {}, .color = std::string(plot::kGrey), .style = plot::Style::Dots};
  std::array<plot::Series, 3> formal;
  for (const Condition condition : {Condition::Force, Condition::Vision, Condition::Both})
    formal[static_cast<std::size_t>(condition)] = {.name = std::string(name(condition)),
                                                   .x = {},
                                                   .y = {},
                                                   .color = std::string(color_of(condition)),
                                                   .style = plot::Style::Dots};
  double number = 0.0;
  for (const Attempt& attempt : person.attempts) {
    if (attempt.kind == AttemptKind::BrokenOff) continue;
    number += 1.0;
    if (!attempt.trial.outcome.through) continue;
    plot::Series& series =
        attempt.kind == AttemptKind::Training ? training : formal[static_cast<std::size_t>(attempt.trial.condition)];
    series.x.push_back(number);
    series.y.push_back(1e3 * attempt.trial.outcome.overshoot_m);
  }
  if (!training.x.empty()) chart.series.push_back(std::move(training));
  for (plot::Series& series : formal)
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  return chart.series.empty() ? "" : plot::to_svg(chart);
}

std::string condition_table(const PeopleResult& result) {
  Rows rows;
  for (const PeopleCondition& one : result.conditions)
    rows.push_back({std::string(name(one.condition)), interval_or_dash(one.all), std::to_string(one.penetrations),
                    std::to_string(one.not_through), std::to_string(one.not_stopped), std::to_string(one.broken_off),
                    fixed_text(1e3 * one.held_up_s, 0)});
  return report::table({"condition", "overshoot, all mechanisms [mm]", "penetrations", "sac not punctured",
                        "tip not stopped", "broken off and repeated", "longest hold-up [ms]"},
                       rows);
}

std::string mechanism_table(const Protocol& protocol, const PeopleResult& result) {
  std::vector<std::string> head{"mechanism"};
  for (const PeopleCondition& one : result.conditions) head.emplace_back(name(one.condition));
  if (protocol.design.of_the_paper) head.emplace_back("S4 (SD)");
  Rows rows;
  for (std::size_t i = 0; i < protocol.design.configurations.size(); ++i) {
    std::vector<std::string> row{std::to_string(i + 1) + ": " + protocol.design.configurations[i].name};
    for (const PeopleCondition& one : result.conditions) row.push_back(interval_or_dash(one.cells[i]));
    if (protocol.design.of_the_paper)
      row.push_back(fixed_text(paper_table()[i].overshoot_mm) + " (" + fixed_text(paper_table()[i].deviation_mm) + ")");
    rows.push_back(std::move(row));
  }
  return "<div class=\"scroll\">" + report::table(head, rows) + "</div>";
}

std::string people_table(const Protocol& protocol, const PeopleResult& result) {
  Rows rows;
  for (const PersonRecord& person : result.people.records)
    rows.push_back({person.participant.name, std::to_string(person.done) + " of " + std::to_string(person.planned),
                    std::string(words(protocol.hand))});
  return report::table({"participant", "penetrations done", "hand"}, rows, report::Cells::Words);
}

std::string plant_table(const PeopleResult& result) {
  std::vector<std::string> head{"parameter"};
  for (const PersonRecord& person : result.people.records) head.push_back(person.participant.name);
  Rows rows;
  for (const Drawn<Plant>& one : plant_ranges()) {
    rows.push_back({std::string(one.name) + (one.unit.empty() ? "" : " [" + std::string(one.unit) + "]")});
    for (const PersonRecord& person : result.people.records)
      rows.back().push_back(fixed_text(person.plant.*one.value, 3));
  }
  return "<div class=\"scroll\">" + report::table(head, rows) + "</div>";
}

std::string hand_rules(PersonHand hand) {
  if (hand == PersonHand::Device)
    return "<dt>haptic device</dt><dd>the end-effector is the hand at the handle's end. Each penetration begins where "
           "the end-effector then is. The force of needle and mechanism passes the limiter that the station uses, and "
           "is given in the conditions with force alone. A device that stops answering ends the penetration, which is "
           "asked for again</dd>"
           "<dt>hold-up</dt><dd>time that a penetration lost because the program was late</dd>";
  const Operator arm = browser_arm();
  return "<dt>browser</dt><dd>force shown as a bar: a mouse gives no force. Between pointer and handle an arm is "
         "simulated, " +
         number_text(arm.arm_N_per_m) + " N/m, " + number_text(arm.arm_kg) + " kg, damping ratio " +
         number_text(arm.arm_damping) +
         ", which the force moves in the conditions with force. The pointer moves the far end of this arm along the "
         "path of the handle</dd>"
         "<dt>hold-up</dt><dd>time that a penetration lost because the program or the browser was late. The hand "
         "then moved slower than the pointer</dd>";
}

std::string rules(const Protocol& protocol, const PeopleResult& result) {
  std::string text =
      "<dl class=\"meanings\">" + std::string(kTaskRules) + "<dt>interval</dt><dd>95 %, percentile bootstrap. ";
  text +=
      result.people.records.size() == 1
          ? "There is one participant: the interval of a mechanism is over the penetrations with it, that of a "
            "condition over the mechanisms. It says nothing about other people</dd>"
          : "It is over the participants. Each works on a separate sample of the numbers that S4 does not give</dd>";
  text +=
      "<dt>order</dt><dd>the conditions in random order; in each, training, then all mechanisms in random order. "
      "The order depends on the seed and the participant</dd>"
      "<dt>broken off</dt><dd>the person let go before the puncture, by Escape or because the page was no longer in "
      "front. The penetration was asked for again. After the puncture it counts: the hand stands still until the tip "
      "has stopped</dd>" +
      hand_rules(protocol.hand) + "</dl>";
  return text;
}

}  // namespace

std::string people_html(const Protocol& protocol, const PeopleResult& result) {
  const std::string title = "Protocol with people: " + std::filesystem::path(protocol.design.name).filename().string();
  std::string said;
  for (const std::string& sentence : people_findings(protocol, result))
    said += "<p>" + plot::escaped(sentence) + "</p>";
  std::string headline;
  for (const PeopleCondition& one : result.conditions)
    headline +=
        (headline.empty() ? "" : "; ") + std::string(name(one.condition)) + ": " + interval_or_dash(one.all) + " mm";
  std::string page = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + plot::escaped(title) +
                     "</title><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>" +
                     std::string(report::kStyle) + "</style></head><body><h1>" + plot::escaped(title) +
                     "</h1><p class=\"from\">" + plot::escaped(identity_of(protocol)) + "</p>";
  page += "<div class=\"verdict none\"><div class=\"headline\">Overshoot, " + headline + "</div>" + said + "</div>";
  page += report::section("Overshoot", "Dots are means, lines their 95 % intervals; see Rules.",
                          overshoots(protocol, result) + condition_table(result) + mechanism_table(protocol, result));
  std::string charts;
  for (const PersonRecord& person : result.people.records) charts += learning(person);
  page += report::section("Who took part", "How each was done, and in which order.",
                          people_table(protocol, result) + charts);
  page += report::section("Rules", "What the words of this page mean.", rules(protocol, result));
  page +=
      report::section("What S4 does not give",
                      "Drawn once for each participant, from the ranges of the simulated study.", plant_table(result));
  return page + "</body></html>\n";
}

}  // namespace telepalp::study
