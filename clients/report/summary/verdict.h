#pragma once

#include <string>
#include <vector>

#include "clients/report/summary/moments.h"
#include "clients/report/summary/path_limits.h"
#include "clients/report/summary/summary.h"

namespace telepalp::report {

/// Result of comparing a value with its budget.
enum class Standing { Holds, Misses, NotMeasured };

/// Kinds of causes, in the order in which the report lists them: what a reader needs first comes first.
enum class Rank { Safety, Depth, Latency, Images, Loop, Clock, Recording, Computer };

/// Which single samples can miss a figure's budget: the report tells when they did. A p99, for example, is made of such
/// samples; a count is not (Measurement::None).
struct Each {
  Measurement sample = Measurement::None;
  double limit = 0.0;  ///< a sample beyond it is a moment at which the budget was missed
};

/// One value with its budget.
struct Check {
  std::string name;  ///< "tick time, p99.9"
  double value = kUnknown;
  double budget = 0.0;
  std::string unit;
  bool at_most = true;  ///< true: the budget is an upper limit; false: a lower limit
  Rank rank = Rank::Loop;
  std::string brief;    ///< for the headline, when the budget is missed: "a tick took too long"
  std::string meaning;  ///< consequence for the doctor, and where it comes from
  std::string to_do;    ///< what to do about it
  Each each{};

  [[nodiscard]] Standing standing() const noexcept;
};

/// A reason for which a run needs to be looked at, and what to do about it.
struct Cause {
  std::string what;
  std::string to_do;
  std::string when{};  ///< the moments, and whether the hand was in contact then; empty: not known
};

/// The overall assessment of a run.
struct Verdict {
  bool good = false;          ///< exactly one station took part, and no check misses its budget
  std::string headline;       ///< at most two lines: "Check this run: the network made the touch 428 ms late."
  std::string account;        ///< what happened, in a few sentences
  std::vector<Cause> causes;  ///< of a run that is not good, the most important first
  std::vector<Check> checks;
};

/// "telepalp-station at 127.0.0.1:40112"
[[nodiscard]] std::string in_words(const SenderSummary& sender);

/// `path`: whose limits of latency the run must meet. `session`: where the moments of the causes are looked up;
/// nullptr: the causes name none.
[[nodiscard]] Verdict judge(const Summary& summary, const PathLimits& path = kPaths.front(),
                            const Session* session = nullptr);

}  // namespace telepalp::report
