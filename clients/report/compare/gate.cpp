#include "clients/report/compare/gate.h"

#include <algorithm>
#include <cmath>

#include "clients/report/compare/cause.h"
#include "clients/report/compare/comparison.h"
#include "support/plot/number.h"

namespace telepalp::report {

bool GateOutcome::holds() const noexcept {
  return std::all_of(differences.begin(), differences.end(), [](const Difference& one) { return one.holds(); }) &&
         std::any_of(differences.begin(), differences.end(),
                     [](const Difference& one) { return !std::isnan(one.value); });
}

GateOutcome judge_against(const Comparison& comparison, const std::vector<Tolerance>& tolerances) {
  GateOutcome outcome{.differences = differences_of(comparison, tolerances), .causes = {}};
  if (!outcome.holds()) outcome.causes = causes_of(comparison);
  return outcome;
}

Result<GateOutcome> judge_against(const std::filesystem::path& a, const std::filesystem::path& b,
                                  const std::vector<Tolerance>& tolerances) {
  const Result<Comparison> comparison = compare(a, b);
  if (!comparison) return comparison.error();
  return judge_against(*comparison, tolerances);
}

std::string in_words(const Difference& difference) {
  const Tolerance& tolerance = difference.tolerance;
  const std::string name(tolerance.name), unit(tolerance.unit);
  if (std::isnan(difference.value)) return name + " is not measured: neither run has the figure";
  const std::string detail = difference.detail.empty() ? "" : " (" + difference.detail + ")";
  const std::string tolerated = ", tolerance " + plot::readable(tolerance.at_most) + " " + unit;
  if (std::isinf(difference.value)) return name + " cannot be compared" + detail + tolerated;
  return name + " is " + plot::readable(difference.value) + " " + unit + tolerated + detail;
}

std::string in_words(const GateOutcome& outcome) {
  std::string text;
  for (const Difference& one : outcome.differences)
    text += (one.holds() ? "holds: " : "FAILS: ") + in_words(one) +
            (one.holds() ? "" : ": " + std::string(one.tolerance.what)) + "\n";
  if (outcome.holds()) return text + "The run is within the tolerances of the baseline.\n";
  text += "Likely causes (A: baseline, B: run):\n";
  for (std::size_t i = 0; i < outcome.causes.size(); ++i)
    text += "  " + std::to_string(i + 1) + ". " + outcome.causes[i] + "\n";
  return text;
}

std::filesystem::path session_file(const std::filesystem::path& asked) {
  return std::filesystem::is_directory(asked) ? asked / "session.mcap" : asked;
}

}  // namespace telepalp::report
