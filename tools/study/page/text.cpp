#include <algorithm>
#include <array>
#include <cstdio>

#include "proto/words/numbers/fixed_text.h"
#include "support/program/json.h"
#include "tools/study/page/files.h"
#include "tools/study/page/words.h"
#include "tools/study/run/parts.h"
#include "tools/study/run/trial_row.h"

namespace telepalp::study {
namespace {

template <class... Values>
std::string line(const char* form, Values... values) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), form, values...);
  return text.data();
}

void add(program::Json& json, std::string_view key, const Interval& interval) {
  json.begin_object(key);
  json.add("mean_mm", interval.mean);
  json.add("low_mm", interval.low);
  json.add("high_mm", interval.high);
  json.end_object();
}

void add_paper(program::Json& json, const StudyResult& result) {
  json.begin_object("against_paper");
  for (std::size_t i = 0; i < kStudied.size(); ++i) {
    json.begin_object(name(kStudied[i]));
    const Correlation& one = *result.correlations[i];
    json.add("rank_correlation", one.of_means);
    json.add("of_operators_least", one.least);
    json.add("of_operators_median", one.median);
    json.add("of_operators_most", one.most);
    json.end_object();
  }
  json.add("lever_alone", result.lever_alone);
  json.add("ceiling_if_over_penetrations", result.ceiling_penetrations);
  json.add("ceiling_if_over_subjects", result.ceiling_subjects);
  json.begin_list("patterns");
  for (const Pattern& one : result.patterns) {
    json.begin_object();
    json.add("what", one.what);
    json.add("in_paper", one.in_paper);
    json.add("here", one.here);
    json.add("holds", one.holds);
    json.add("certainty", one.certainty);
    json.end_object();
  }
  json.end_list();
  json.begin_list("effects");
  for (const Effect& one : result.effects) {
    json.begin_object();
    json.add("name", one.name());
    json.add("rms_mm", one.spread);
    json.add("p", one.p);
    json.end_object();
  }
  json.end_list();
  json.end_object();
}

void add_check(program::Json& json, const Check& check) {
  json.begin_object("check_against_gerovich_2004");
  json.add("neither_mm", 1e3 * check.neither_m);
  json.add("force_mm", 1e3 * check.force_m);
  json.add("sees_layers_mm", 1e3 * check.sees_layers_m);
  json.add("both_mm", 1e3 * check.both_m);
  json.end_object();
}

}  // namespace

std::string result_text(const StudySettings& settings, const StudyResult& result) {
  std::string text = "overshoot past the first contact with the sac, mm; mean of " +
                     std::to_string(settings.operators) + " operators (95 % interval)\n\n";
  text += line("%-38s %-20s %-20s %-20s %-12s%s\n", "mechanism", "force", "vision", "both", "no reflexes",
               settings.design.of_the_paper ? "S4, Table 2 (SD)" : "");
  for (std::size_t i = 0; i < settings.design.configurations.size(); ++i) {
    std::array<std::string, 4> cell;
    for (std::size_t c = 0; c < 4; ++c) cell[c] = in_words(result.conditions[c].cells[i]);
    text += line("%-38s %-20s %-20s %-20s %-12s", settings.design.configurations[i].name.c_str(), cell[0].c_str(),
                 cell[1].c_str(), cell[2].c_str(), fixed_text(result.conditions[3].cells[i].mean).c_str());
    if (settings.design.of_the_paper)
      text += fixed_text(paper_table()[i].overshoot_mm) + " (" + fixed_text(paper_table()[i].deviation_mm) + ")";
    text += "\n";
  }
  text += line("%-38s %-20s %-20s %-20s %-12s\n", "all", in_words(result.conditions[0].all).c_str(),
               in_words(result.conditions[1].all).c_str(), in_words(result.conditions[2].all).c_str(),
               fixed_text(result.conditions[3].all.mean).c_str());
  text += "\ncheck of the operators, straight needle, against Gerovich 2004: force " +
          change(result.check.force_m, result.check.neither_m) + " (there at least -52 %), live sight of the layers " +
          change(result.check.sees_layers_m, result.check.neither_m) + " (there at least -87 %)\n\n";
  if (result.left_out > 0)
    text += std::to_string(result.left_out) +
            " operators never punctured the sac with some mechanism, and are left out of all overshoots\n";
  for (const std::string& sentence : findings(settings, result)) text += sentence + "\n";
  for (const Pattern& one : result.patterns)
    text += "  " + std::string(verdict(one)) + ": " + one.what + "; S4 " + one.in_paper + ", here " + one.here + "\n";
  return text;
}

std::string result_json(const StudySettings& settings, const StudyResult& result) {
  program::Json json;
  json.begin_object();
  json.add("program", "telepalp-study");
  json.add("identity", identity_of(settings));
  json.add("design", settings.design.name);
  json.add("operators", static_cast<std::uint64_t>(settings.operators));
  json.add("operators_left_out", static_cast<std::uint64_t>(result.left_out));
  json.add("seed", settings.seed);
  add_check(json, result.check);
  for (std::size_t c = 0; c < kStudied.size(); ++c) {
    const ConditionResult& condition = result.conditions[c];
    json.begin_object(name(kStudied[c]));
    add(json, "all", condition.all);
    json.add("noticed_share", condition.noticed_share);
    json.add("not_through", static_cast<std::uint64_t>(condition.not_through));
    json.add("not_stopped", static_cast<std::uint64_t>(condition.not_stopped));
    for (std::size_t i = 0; i < condition.cells.size(); ++i)
      add(json, settings.design.configurations[i].name, condition.cells[i]);
    json.end_object();
  }
  add(json, "force_against_vision", result.force_against_vision);
  add(json, "both_against_vision", result.both_against_vision);
  if (settings.design.of_the_paper) add_paper(json, result);
  json.end_object();
  return std::move(json).finish();
}

std::string trials_csv(const StudySettings& settings, const std::vector<Trial>& trials) {
  std::vector<std::string> rows;
  for (const Trial& trial : trials) rows.push_back(trial_row(trial));
  return rows_text(identity_of(settings), kTrialColumns, rows);
}

}  // namespace telepalp::study
