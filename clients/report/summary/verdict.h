#pragma once

#include <string>
#include <vector>

#include "clients/report/summary/summary.h"

namespace telepalp::report {

/// Result of comparing a value with its budget.
enum class Standing { Holds, Misses, NotMeasured };

/// One value with its budget.
struct Check {
  std::string name;  ///< "tick time, p99.9"
  double value = kUnknown;
  double budget = 0.0;
  std::string unit;
  bool at_most = true;           ///< true: the budget is an upper limit; false: a lower limit
  std::string meaning;           ///< consequence for the doctor when the budget is missed
  bool of_the_computer = false;  ///< the station's computer, not telepalp, determines this value

  [[nodiscard]] Standing standing() const noexcept;
};

/// The overall assessment of a run.
struct Verdict {
  bool good = false;     ///< exactly one station took part, and no check misses its budget
  std::string headline;  ///< for example "The run was good: every measured figure meets its requirement."
  std::string account;   ///< what happened, in a few sentences
  std::vector<Check> checks;
};

/// "telepalp-station at 127.0.0.1:40112"
[[nodiscard]] std::string in_words(const SenderSummary& sender);

[[nodiscard]] Verdict judge(const Summary& summary);

}  // namespace telepalp::report
