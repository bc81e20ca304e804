#include <algorithm>

#include "clients/report/figures/html.h"
#include "proto/words/error_line.h"
#include "proto/words/numbers/fixed_text.h"
#include "support/plot/chart.h"
#include "support/plot/heat_map.h"
#include "support/plot/palette.h"
#include "support/plot/svg.h"
#include "tools/study/page/files.h"
#include "tools/study/page/overshoot_figures.h"
#include "tools/study/page/words.h"
#include "tools/study/run/trial_row.h"

namespace telepalp::study {
namespace {

using Rows = std::vector<std::vector<std::string>>;

constexpr std::string_view kConditionColors[] = {plot::kBlue, plot::kGreen, plot::kVermilion, plot::kGrey};

std::string overshoots(const StudySettings& settings, const StudyResult& result) {
  plot::Chart chart = overshoot_chart(settings.design.configurations.size());
  for (const std::size_t c : {1, 2})
    add_overshoots(chart, name(result.conditions[c].condition), result.conditions[c].cells, kConditionColors[c]);
  if (settings.design.of_the_paper) add_paper(chart);
  return plot::to_svg(chart);
}

std::string heat_maps(const StudyResult& result) {
  std::vector<double> here;
  for (const Interval& cell : result.conditions[2].cells) here.push_back(cell.mean);
  for (double& value : here) value = 0.1 * static_cast<double>(static_cast<int>(10.0 * value + 0.5));
  return "<div class=\"pair\">" + plot::to_svg(table_2_map("Here, with both senses: overshoot [mm]", here)) +
         plot::to_svg(table_2_map("S4, Table 2: overshoot [mm]", paper_overshoots_mm())) + "</div>";
}

std::string mechanism_table(const StudySettings& settings, const StudyResult& result) {
  std::vector<std::string> head{"mechanism", "force", "vision", "both", "no reflexes", "force falls by [N]"};
  if (settings.design.of_the_paper) head.emplace_back("S4 (SD)");
  Rows rows;
  for (std::size_t i = 0; i < settings.design.configurations.size(); ++i) {
    std::vector<std::string> row{std::to_string(i + 1) + ": " + settings.design.configurations[i].name};
    for (const ConditionResult& condition : result.conditions) row.push_back(in_words(condition.cells[i]));
    row.push_back(fixed_text(result.hand_drop_N[i], 2));
    if (settings.design.of_the_paper)
      row.push_back(fixed_text(paper_table()[i].overshoot_mm) + " (" + fixed_text(paper_table()[i].deviation_mm) + ")");
    rows.push_back(std::move(row));
  }
  return "<div class=\"scroll\">" + report::table(head, rows) + "</div>";
}

std::string condition_table(const StudyResult& result) {
  Rows rows;
  for (const ConditionResult& one : result.conditions)
    rows.push_back({std::string(name(one.condition)), in_words(one.all),
                    fixed_text(100.0 * one.noticed_share, 0) + " %", std::to_string(one.not_through),
                    std::to_string(one.not_stopped)});
  return report::table(
      {"condition", "overshoot, all mechanisms [mm]", "puncture noticed", "sac not punctured", "tip not stopped"},
      rows);
}

std::string correlation_table(const StudyResult& result) {
  Rows rows;
  for (std::size_t i = 0; i < kStudied.size(); ++i) {
    const Correlation& one = *result.correlations[i];
    rows.push_back({std::string(name(kStudied[i])), fixed_text(one.of_means, 2), fixed_text(one.least, 2),
                    fixed_text(one.median, 2), fixed_text(one.most, 2)});
  }
  rows.push_back({"the hand's lever alone", fixed_text(result.lever_alone, 2), "", "", ""});
  rows.push_back(
      {"a perfect model, if S4's SD is over 20 penetrations", fixed_text(result.ceiling_penetrations, 2), "", "", ""});
  rows.push_back(
      {"a perfect model, if S4's SD is over 4 subjects", fixed_text(result.ceiling_subjects, 2), "", "", ""});
  return report::table({"", "of the means", "of one operator: least", "median", "most"}, rows);
}

std::string pattern_table(const StudyResult& result) {
  Rows rows;
  for (const Pattern& one : result.patterns)
    rows.push_back({one.what, one.in_paper, one.here,
                    std::string(verdict(one)) + " (" + fixed_text(100.0 * one.certainty, 0) + " % of the resamples)"});
  return report::table({"pattern", "S4", "here", ""}, rows, report::Cells::Words);
}

std::string effect_table(const StudyResult& result) {
  Rows rows;
  for (const Effect& one : result.effects) {
    std::string levels;
    for (const double mean : one.means) levels += (levels.empty() ? "" : " / ") + fixed_text(mean);
    rows.push_back({one.name(), levels, fixed_text(one.spread, 2), one.p < 0.0015 ? "≤ 0.001" : fixed_text(one.p, 3)});
  }
  return report::table({"effect", "means of the levels [mm]", "size, RMS [mm]", "p"}, rows);
}

std::string check_table(const Check& check) {
  const Rows rows{{"neither", fixed_text(1e3 * check.neither_m), "", ""},
                  {"force", fixed_text(1e3 * check.force_m), change(check.force_m, check.neither_m), "at least -52 %"},
                  {"live sight of the layers", fixed_text(1e3 * check.sees_layers_m),
                   change(check.sees_layers_m, check.neither_m), "at least -87 %"},
                  {"force, and sight of the needle alone", fixed_text(1e3 * check.both_m),
                   change(check.both_m, check.neither_m), "not measured there"}};
  return report::table({"condition", "overshoot after the puncture [mm]", "against neither", "Gerovich 2004"}, rows);
}

template <class Owner>
std::string range_table(std::span<const Drawn<Owner>> ranges) {
  Rows rows;
  for (const Drawn<Owner>& one : ranges)
    rows.push_back({std::string(one.name),
                    number_text(one.least) + " to " + number_text(one.most) + " " + std::string(one.unit),
                    std::string(one.source)});
  return report::table({"parameter", "range", "source"}, rows, report::Cells::Words);
}

constexpr std::string_view kStatisticsRules =
    "<dt>interval</dt><dd>95 %, by a bootstrap over the operators. Each operator works on a separate sample of the "
    "numbers that S4 does not "
    "give, so the interval covers these numbers, too</dd>"
    "<dt>p</dt><dd>permutation test within the operators, 1000 shuffles, not corrected for the number of tests. "
    "For "
    "interactions, the residuals of the main effects are shuffled, an approximation</dd>";

std::string paper_sections(const StudyResult& result) {
  return report::section("Beside S4's Table 2", "Darker is worse. The numbers are means.", heat_maps(result)) +
         report::section("Rank correlation with Table 2",
                         "No range of the plant was fitted to Table 2; docs/study.md tells how the "
                         "operators were made. An operator without reflexes and the lever alone show how "
                         "much of the agreement comes from the "
                         "mechanism, without any sense.",
                         correlation_table(result)) +
         report::section("S4's patterns",
                         "What S4 reads from its table, and in how many of 1000 resamples of the operators it appears "
                         "here, with both senses. S4 gives no intervals.",
                         pattern_table(result)) +
         report::section("Main effects and interactions", "Condition both. Permutation tests; see Rules.",
                         effect_table(result));
}

}  // namespace

std::string result_html(const StudySettings& settings, const StudyResult& result) {
  std::string said;
  for (const std::string& sentence : findings(settings, result)) said += "<p>" + plot::escaped(sentence) + "</p>";
  const std::string title = "Study of " + settings.design.name;
  std::string page =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + plot::escaped(title) +
      "</title><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>" +
      std::string(report::kStyle) + "</style></head><body><h1>" + plot::escaped(title) + "</h1><p class=\"from\">" +
      plot::escaped(identity_of(settings) + "; " + std::to_string(settings.operators) + " simulated operators") +
      "</p>";
  page += "<div class=\"verdict none\"><div class=\"headline\">Overshoot with force and sight: " +
          in_words(result.conditions[2].all) + " mm; with sight alone: " + in_words(result.conditions[1].all) +
          " mm</div>" + said + "<p>All operators are simulated. No person took part." +
          (result.left_out > 0
               ? " " + std::to_string(result.left_out) +
                     " of them never punctured the sac with some mechanism, and are left out of all overshoots."
               : "") +
          "</p></div>";
  page += report::section("Overshoot", "Dots are means over the operators, lines their 95 % intervals.",
                          overshoots(settings, result) + condition_table(result) + mechanism_table(settings, result));
  if (settings.design.of_the_paper) page += paper_sections(result);
  page += report::section(
      "Check of the operators",
      "Before the study, with a straight needle, against people: Gerovich 2004, 14 subjects, skin, fat and muscle. "
      "After the first check (force -56 %, live sight -70 %) the operator's speed was made to depend on how "
      "certain the depth is. docs/study.md tells what was changed later.",
      check_table(result.check));
  page +=
      report::section("Rules", "What the words of this page mean.",
                      "<dl class=\"meanings\">" + std::string(kTaskRules) + std::string(kStatisticsRules) + "</dl>");
  page += report::section("The operators", "Each value is drawn evenly from its range, once for each operator.",
                          range_table(operator_ranges()));
  page += report::section("What S4 does not give", "Drawn as above. Each operator works on a separate sample.",
                          range_table(plant_ranges()));
  return page + "</body></html>\n";
}

}  // namespace telepalp::study
