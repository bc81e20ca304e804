#pragma once

#include <string>
#include <vector>

#include "clients/report/compare/run.h"

namespace telepalp::report {

/// The value of one metric in both runs; NaN (kUnknown) where a run lacks it.
struct MetricPair {
  std::string name;
  std::string unit;
  double a = kUnknown;
  double b = kUnknown;
  enum class Better { Less, More, Neither } better = Better::Less;

  double matters = 0.0;  ///< a difference up to this counts as none [unit]

  /// True if b is worse than a by more than `matters`, and by more than a thousandth of the larger magnitude. False if
  /// one is unknown.
  [[nodiscard]] bool worse() const noexcept;
  /// True if both are known and differ by at most `matters`.
  [[nodiscard]] bool same() const noexcept;
};

/// The metrics of both sessions. Metrics that neither run has are left out.
[[nodiscard]] std::vector<MetricPair> metric_pairs(const Summary& a, const Summary& b);

/// The metrics of telepalp-replay, which compare each run with the same run over a network without delay and loss, and
/// with the synthetic patient's exact skin. Empty unless telepalp-replay wrote both runs.
[[nodiscard]] std::vector<MetricPair> replay_metric_pairs(const Run& a, const Run& b);

}  // namespace telepalp::report
