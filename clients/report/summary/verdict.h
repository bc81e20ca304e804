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
  bool at_most = true;           ///< else the budget is the least that will do
  std::string meaning;           ///< what it is to the doctor when it misses
  bool of_the_computer = false;  ///< no doing of telepalp's: the computer that the station runs on

  [[nodiscard]] Standing standing() const noexcept;
};

/// A run judged.
struct Verdict {
  bool good = false;     ///< no check misses, and there was a station to judge
  std::string headline;  ///< "The run was good."
  std::string account;   ///< what happened, in two or three sentences
  std::vector<Check> checks;
};

/// "telepalp-station at 127.0.0.1:40112"
[[nodiscard]] std::string in_words(const SenderSummary& sender);

[[nodiscard]] Verdict judge(const Summary& summary);

}  // namespace telepalp::report
