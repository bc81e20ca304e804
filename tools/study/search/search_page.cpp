#include "tools/study/search/search_page.h"

#include <cmath>

#include "clients/report/figures/html.h"
#include "proto/words/error_line.h"
#include "proto/words/numbers/fixed_text.h"
#include "support/plot/chart.h"
#include "support/plot/palette.h"
#include "support/plot/svg.h"
#include "tools/study/search/judgement_file.h"
#include "tools/study/search/linkage_drawing.h"
#include "tools/study/search/search_words.h"

namespace telepalp::study {
namespace {

using Rows = std::vector<std::vector<std::string>>;

plot::Series series(std::string name, std::string_view color, plot::Style style = plot::Style::Dots) {
  return {.name = std::move(name), .x = {}, .y = {}, .color = std::string(color), .style = style};
}

void add(plot::Series& to, const Judgement& judgement) {
  if (!judgement.refused.empty()) return;
  to.x.push_back(judgement.hand_N.mean);
  to.y.push_back(judgement.overshoot_mm.mean);
}

plot::Series feasible(const std::vector<SearchedDesign>& designs, std::string name, std::string_view color) {
  plot::Series dots = series(std::move(name), color);
  for (const SearchedDesign& one : designs)
    if (one.searched.feasible()) add(dots, one.searched);
  return dots;
}

std::string front_chart(const SearchResult& result) {
  plot::Series by_search = series("front, by the operators of the search", plot::kBlue, plot::Style::Path);
  plot::Series dots = series("", plot::kBlue);
  plot::Series by_others = series("the same mechanisms, by held-out operators", plot::kVermilion, plot::Style::Path);
  plot::Series other_dots = series("", plot::kVermilion);
  plot::Series intervals = series("", plot::kVermilion, plot::Style::Path);
  for (const SearchedDesign& one : result.front) {
    add(by_search, one.searched);
    add(dots, one.searched);
    if (!one.held_out || !one.held_out->refused.empty()) continue;
    add(by_others, *one.held_out);
    add(other_dots, *one.held_out);
    for (const double y : {one.held_out->overshoot_mm.low, one.held_out->overshoot_mm.high, std::nan("")}) {
      intervals.x.push_back(one.held_out->hand_N.mean);
      intervals.y.push_back(y);
    }
  }
  const plot::Chart chart{
      .title = "Overshoot against the largest force on the hand; lower left is better",
      .x = {.label = "largest force of the needle on the hand [N]"},
      .y = {.label = "overshoot [mm]"},
      .series = {feasible(result.searched, "mechanisms of the search", "#c3c8cf"),
                 feasible(result.paper, "S4's 36", plot::kBlack), intervals, by_others, other_dots, by_search, dots},
      .height_px = 460.0};
  return plot::to_svg(chart);
}

std::string design_table(const SearchResult& result) {
  std::vector<std::string> head{
      "", "overshoot [mm], search", "held out", "hand [N], search", "held out", "noticed", "failed"};
  for (const MechanismParameter& one : mechanism_parameters())
    head.push_back(std::string(one.name) + (one.unit == 1.0 ? " [rad]" : " [mm]"));
  Rows rows;
  for (const ShownDesign& one : shown_designs(result)) {
    const SearchedDesign& design = *one.design;
    std::vector<std::string> row{one.from + ": " + design.mechanism.name,
                                 in_words_2(design.searched.overshoot_mm),
                                 "",
                                 in_words_2(design.searched.hand_N),
                                 "",
                                 "",
                                 ""};
    if (design.held_out) {
      row[2] = design.held_out->refused.empty() ? in_words_2(design.held_out->overshoot_mm) : "refused";
      row[4] = design.held_out->refused.empty() ? in_words_2(design.held_out->hand_N) : "refused";
      row[5] = fixed_text(100.0 * design.held_out->noticed_share, 0) + " %";
      row[6] = std::to_string(design.held_out->failed);
    }
    for (std::string& text : parameter_texts(design.mechanism)) row.push_back(std::move(text));
    rows.push_back(std::move(row));
  }
  return "<div class=\"scroll\">" + report::table(head, rows) + "</div>";
}

std::string drawings(const SearchResult& result) {
  std::string all = "<div style=\"display:flex;flex-wrap:wrap;gap:12px\">";
  for (const ShownDesign& one : shown_designs(result))
    all += "<div style=\"flex:0 0 210px\">" + linkage_drawing(one.design->mechanism, one.from) + "</div>";
  return all + "</div>";
}

std::string box_table(const SearchBox& box) {
  Rows rows;
  for (const SearchRange& range : box.ranges)
    rows.push_back({range.name, number_text(range.least), number_text(range.most)});
  return report::table({"parameter", "least", "most"}, rows);
}

constexpr std::string_view kRules =
    "<dl class=\"meanings\"><dt>overshoot</dt><dd>from the first contact with the sac to the tip at the stop, as in "
    "the "
    "study; mean of each operator's penetrations, then of the operators</dd>"
    "<dt>force on the hand</dt><dd>largest force of the needle on the hand in a penetration, through the mechanism; "
    "means as above</dd>"
    "<dt>same chance</dt><dd>each mechanism is judged by the same operators on the same plants with the same random "
    "numbers, so two mechanisms differ by the mechanism alone</dd>"
    "<dt>failure</dt><dd>a linkage that cannot close or cannot draw its needle out on some operator's plant, and one "
    "with which the sac stayed whole in some penetration, is infeasible: it has no overshoot, and is on no front</dd>"
    "<dt>held out</dt><dd>operators who took no part in the search, with other bodies, plants and random numbers. The "
    "search's own value chose the mechanism, so it is biased towards too good</dd>"
    "<dt>interval</dt><dd>95 %, by a bootstrap over the operators</dd></dl>";

}  // namespace

std::string search_html(const SearchBox& box, const SearchSettings& settings, const SearchResult& result) {
  const std::vector<std::string> said = search_findings(settings, result);
  std::string page =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Search for a mechanism</title><meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>" +
      std::string(report::kStyle) + "</style></head><body><h1>Search for a mechanism</h1><p class=\"from\">" +
      plot::escaped(identity_of(settings)) + "</p><div class=\"verdict none\"><div class=\"headline\">" +
      plot::escaped(said.front()) + "</div>";
  for (std::size_t i = 1; i < said.size(); ++i) page += "<p>" + plot::escaped(said[i]) + "</p>";
  page += "<p>All operators are simulated. No person took part.</p></div>";
  page += report::section("The front",
                          "Each mechanism of the front has the least overshoot that was found within a bound on the "
                          "hand's force. Lines through red dots are 95 % intervals.",
                          front_chart(result) + design_table(result));
  page += report::section("The mechanisms",
                          "When the tip touches the sac. Link 4, grey, is fixed; link 1 is blue, link 2 green, link 3 "
                          "purple, the handle red. All have one scale.",
                          drawings(result));
  page += report::section("Where was searched", "Lengths in mm, angles in rad.", box_table(box));
  page += report::section("Rules", "What the words of this page mean.", std::string(kRules));
  return page + "</body></html>\n";
}

}  // namespace telepalp::study
