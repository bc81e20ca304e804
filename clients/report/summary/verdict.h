#pragma once

#include <string>
#include <vector>

#include "clients/report/summary/summary.h"

namespace telepalp::report {

/// Whether a figure keeps its budget.
enum class Standing { Holds, Misses, NotMeasured };

/// One figure against what is asked of it.
struct Check {
  std::string name;  ///< "tick time, p99.9"
  double value = kUnknown;
  double budget = 0.0;
  std::string unit;
  bool at_most = true;  ///< else the budget is the least that will do
  std::string meaning;  ///< what it is to the doctor when it misses

  [[nodiscard]] Standing standing() const noexcept;
};

/// A run judged.
struct Verdict {
  bool good = false;     ///< no check misses, and there was a station to judge
  std::string headline;  ///< "The run was good."
  std::string account;   ///< what happened, in two or three sentences
  std::vector<Check> checks;
};

[[nodiscard]] Verdict judge(const Summary& summary);

}  // namespace telepalp::report
