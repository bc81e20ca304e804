#include "tools/study/search/search_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "proto/words/numbers/fixed_text.h"
#include "support/program/json.h"
#include "tools/study/search/judgement_file.h"
#include "tools/study/search/search_page.h"

namespace telepalp::study {
namespace {

void add(program::Json& json, std::string_view key, const Interval& interval) {
  json.begin_object(key);
  json.add("mean", interval.mean);
  json.add("low", interval.low);
  json.add("high", interval.high);
  json.end_object();
}

void add(program::Json& json, std::string_view key, const Judgement& judgement) {
  json.begin_object(key);
  if (!judgement.refused.empty()) json.add("refused", judgement.refused);
  add(json, "overshoot_mm", judgement.overshoot_mm);
  add(json, "hand_N", judgement.hand_N);
  json.add("noticed_share", judgement.noticed_share);
  json.add("penetrations_failed", static_cast<std::uint64_t>(judgement.failed));
  json.add("operators_never_through", static_cast<std::uint64_t>(judgement.never));
  json.end_object();
}

void add(program::Json& json, const SearchedDesign& design, std::string_view from) {
  json.begin_object();
  json.add("from", from);
  json.add("name", design.mechanism.name);
  const std::vector<std::string> texts = parameter_texts(design.mechanism);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const MechanismParameter& one = mechanism_parameters()[i];
    if (texts[i] == "drawn")
      json.add(one.name, texts[i]);
    else
      json.add(one.name, design.mechanism.bar.*one.value / one.unit);
  }
  add(json, "by_searching_operators", design.searched);
  if (design.held_out) add(json, "by_held_out_operators", *design.held_out);
  json.end_object();
}

std::string judged_by_others(const SearchedDesign& design) {
  if (!design.held_out) return "not judged";
  if (!design.held_out->refused.empty()) return "refused";
  std::string text = in_words_2(design.held_out->overshoot_mm);
  if (design.held_out->failed > 0) text += ", " + std::to_string(design.held_out->failed) + " failed";
  return text;
}

std::string gain_sentence(const SearchResult& result) {
  const Interval& gain = *result.gain_mm;
  const std::string interval =
      " (95 % interval " + fixed_text(gain.low, 2) + " to " + fixed_text(gain.high, 2) + " mm)";
  const std::string against = "the best of S4's 36 mechanisms, " + result.paper_best->mechanism.name;
  if (gain.low <= 0.0 && gain.high >= 0.0)
    return "By held-out operators, the found mechanism is not certainly different from " + against + ": " +
           fixed_text(gain.mean, 2) + " mm" + interval + ".";
  return "By held-out operators, the found mechanism overshoots " + fixed_text(std::abs(gain.mean), 2) + " mm " +
         (gain.mean < 0.0 ? "less" : "more") + " than " + against + interval + ".";
}

}  // namespace

std::string in_words_2(const Interval& interval) {
  return fixed_text(interval.mean, 2) + " (" + fixed_text(interval.low, 2) + " to " + fixed_text(interval.high, 2) +
         ")";
}

std::vector<std::string> parameter_texts(const Configuration& mechanism) {
  std::vector<std::string> texts;
  for (const MechanismParameter& one : mechanism_parameters()) {
    const bool drawn = (one.name == "l4" && !mechanism.l4_given) || (one.name == "needle" && !mechanism.needle_given);
    texts.push_back(drawn ? "drawn" : fixed_text(mechanism.bar.*one.value / one.unit, one.unit == 1.0 ? 3 : 1));
  }
  return texts;
}

std::vector<ShownDesign> shown_designs(const SearchResult& result) {
  std::vector<ShownDesign> shown;
  for (const SearchedDesign& one : result.front) shown.push_back({"front " + std::to_string(shown.size() + 1), &one});
  if (result.paper_best) shown.push_back({"best of S4's 36, here", &*result.paper_best});
  if (result.table_2_best) shown.push_back({"best in S4's Table 2", &*result.table_2_best});
  return shown;
}

std::vector<std::string> search_findings(const SearchSettings& settings, const SearchResult& result) {
  std::vector<std::string> said;
  if (result.front.empty()) return {"No judged mechanism let every operator puncture the sac each time."};
  const SearchedDesign& best = result.front.back();
  said.push_back("Least overshoot: " + best.mechanism.name + ", " + in_words_2(best.searched.overshoot_mm) +
                 " mm by the " + std::to_string(settings.operators) + " operators of the search, " +
                 judged_by_others(best) + " mm by " + std::to_string(settings.held_out) +
                 " others. The first number chose the mechanism, so it is biased towards too good; take the second.");
  if (result.gain_mm) said.push_back(gain_sentence(result));
  if (result.front.size() == 1)
    said.push_back("The front is one mechanism: it has both the least overshoot and the least force on the hand.");
  const auto refused = std::count_if(result.searched.begin(), result.searched.end(),
                                     [](const SearchedDesign& one) { return !one.searched.refused.empty(); });
  const auto failed = std::count_if(result.searched.begin(), result.searched.end(),
                                    [](const SearchedDesign& one) { return one.searched.failed > 0; });
  said.push_back("Besides S4's 36, " + std::to_string(result.searched.size()) + " mechanisms were judged: " +
                 std::to_string(refused) + " could not be used on some operator's plant, and with " +
                 std::to_string(failed) + " some penetration failed. None of these can be on the front.");
  return said;
}

std::string search_text(const SearchSettings& settings, const SearchResult& result) {
  std::string text = "overshoot [mm] and largest force on the hand [N], mean of the operators (95 % interval)\n\n";
  const auto line = [&](auto... cells) {
    std::array<char, 400> row{};
    std::snprintf(row.data(), row.size(), "%-22s %-21s %-21s %-21s %-21s ", cells...);
    text += row.data();
  };
  line("", "overshoot, search", "overshoot, held out", "hand, search", "hand, held out");
  for (const MechanismParameter& one : mechanism_parameters()) text += std::string(one.name) + " ";
  text += "\n";
  for (const ShownDesign& one : shown_designs(result)) {
    const SearchedDesign& design = *one.design;
    line(one.from.c_str(), in_words_2(design.searched.overshoot_mm).c_str(), judged_by_others(design).c_str(),
         in_words_2(design.searched.hand_N).c_str(),
         design.held_out ? in_words_2(design.held_out->hand_N).c_str() : "not judged");
    for (const std::string& parameter : parameter_texts(design.mechanism)) text += parameter + " ";
    text += "\n";
  }
  text += "\n";
  for (const std::string& sentence : search_findings(settings, result)) text += sentence + "\n";
  return text;
}

std::string search_json(const SearchBox& box, const SearchSettings& settings, const SearchResult& result) {
  program::Json json;
  json.begin_object();
  json.add("program", "telepalp-study search");
  json.add("identity", identity_of(settings));
  json.add("evaluations", static_cast<std::uint64_t>(result.paper.size() + result.searched.size()));
  json.begin_object("box");
  for (const SearchRange& range : box.ranges) {
    json.begin_object(range.name);
    json.add("least", range.least);
    json.add("most", range.most);
    json.end_object();
  }
  json.end_object();
  json.begin_list("designs");
  for (const ShownDesign& one : shown_designs(result)) add(json, *one.design, one.from);
  json.end_list();
  if (result.gain_mm) add(json, "overshoot_of_the_last_of_the_front_minus_best_of_the_36_mm", *result.gain_mm);
  json.end_object();
  return std::move(json).finish();
}

}  // namespace telepalp::study
