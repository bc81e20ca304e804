#include "tools/study/page/words.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "proto/words/numbers/fixed_text.h"

namespace telepalp::study {
namespace {

std::string difference_in_words(const char* what, const Interval& mm) {
  const std::string interval = fixed_text(mm.low) + " to " + fixed_text(mm.high) + " mm";
  if (mm.low <= 0.0 && mm.high >= 0.0)
    return std::string(what) + " makes no certain difference to sight alone: " + fixed_text(mm.mean) + " mm (" +
           interval + ").";
  return std::string(what) + " makes the overshoot " + fixed_text(std::abs(mm.mean)) + " mm " +
         (mm.mean < 0.0 ? "smaller" : "larger") + " than sight alone (" + interval + ").";
}

}  // namespace

std::string in_words(const Interval& interval) {
  return fixed_text(interval.mean) + " (" + fixed_text(interval.low) + " to " + fixed_text(interval.high) + ")";
}

std::string change(double to, double from) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%+.0f %%", 100.0 * (to / from - 1.0));
  return text.data();
}

std::vector<std::string> findings(const StudySettings& settings, const StudyResult& result) {
  const auto& cells = result.conditions[2].cells;
  const auto less = [](const Interval& a, const Interval& b) { return a.mean < b.mean; };
  const auto best = std::min_element(cells.begin(), cells.end(), less);
  const auto worst = std::max_element(cells.begin(), cells.end(), less);
  const auto name_at = [&](auto at) {
    return settings.design.configurations[static_cast<std::size_t>(at - cells.begin())].name;
  };
  std::vector<std::string> out{
      difference_in_words("Force with sight", result.both_against_vision),
      difference_in_words("Force alone", result.force_against_vision),
      "The best mechanism with both is " + name_at(best) + ": " + in_words(*best) + " mm. The worst is " +
          name_at(worst) + ": " + in_words(*worst) + " mm.",
  };
  if (!settings.design.of_the_paper) return out;
  const auto appear = std::count_if(result.patterns.begin(), result.patterns.end(),
                                    [](const Pattern& one) { return verdict(one) == "appears"; });
  out.push_back("The order of the 36 mechanisms agrees with S4's Table 2 by a rank correlation of " +
                fixed_text(result.correlations[2]->of_means, 2) + ". An operator without reflexes reaches " +
                fixed_text(result.correlations[3]->of_means, 2) +
                ", and the hand's lever alone, without any simulation, " + fixed_text(result.lever_alone, 2) +
                ". A perfect model would reach " + fixed_text(result.ceiling_penetrations, 2) +
                " if S4's deviations are over penetrations, and " + fixed_text(result.ceiling_subjects, 2) +
                " if over its four subjects.");
  constexpr double kNoDifference = 0.05;  // of two rank correlations
  if (result.correlations[2]->of_means - result.correlations[3]->of_means < kNoDifference)
    out.emplace_back(
        "So the agreement comes from the mechanism, which throws the hand forward more or less; the simulated senses "
        "add little to it.");
  out.push_back("Of the " + std::to_string(result.patterns.size()) + " patterns that S4 reads from its table, " +
                std::to_string(appear) + " appear here with certainty.");
  return out;
}

}  // namespace telepalp::study
