#pragma once

#include <vector>

namespace telepalp::study {

/// A Bayesian staircase: each trial is placed at the mean of the threshold's distribution, which each answer narrows.
/// Source: Watson and Pelli 1983, QUEST, with King-Smith's mean rule; the share of right answers in a
/// two-interval trial is that of an ideal observer, Phi(z difference / threshold), in place of Weibull's function.
class Quest {
 public:
  /// `guess`: expected threshold, as a Weber fraction; `deviation`: its uncertainty in natural logarithms. `target`:
  /// share of right answers at the threshold. `lapses`: share of answers that are random.
  explicit Quest(double guess = 0.3, double deviation = 1.0, double target = 0.75, double lapses = 0.02);

  /// The stimulus difference of the next trial, as a Weber fraction; after the last trial, the threshold that was
  /// found.
  [[nodiscard]] double difference() const noexcept;
  /// Takes the answer to the trial with the stimulus difference difference().
  void answer(bool right) noexcept;

 private:
  double target_z_;  ///< normal quantile of the target
  double lapses_;
  std::vector<double> log_threshold_;  ///< grid of thresholds, natural logarithms
  std::vector<double> probability_;    ///< of each threshold of the grid; sums to 1
};

}  // namespace telepalp::study
