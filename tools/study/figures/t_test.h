#pragma once

#include <span>

namespace telepalp::study {

/// A sample in three numbers, as papers print it.
struct Sample {
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation with count - 1
  int count = 0;
};
[[nodiscard]] Sample sample_of(std::span<const double> values) noexcept;

/// A t-test of a difference of two means, two-sided, at the level 0.05.
struct TTest {
  double difference = 0.0;  ///< mean of the first minus mean of the second
  double low = 0.0;         ///< 95 % confidence interval of the difference
  double high = 0.0;
  double t = 0.0;
  double degrees = 0.0;  ///< degrees of freedom
  double p = 1.0;
  double effect = 0.0;  ///< Cohen's d: the difference divided by the standard deviation
  double power = 0.0;   ///< post hoc: if the true difference and deviation were the measured ones
};

/// Two groups of different people, whose variances may differ. Source: Welch 1947, with Satterthwaite's degrees of
/// freedom. The effect is in units of the root mean square of both deviations. Each sample has at least two values; if
/// neither has any spread, p is 1 for equal means and else 0.
[[nodiscard]] TTest welch_test(const Sample& first, const Sample& second) noexcept;

/// The same people in two conditions: `first` and `second` have one value for each of at least two people, in the same
/// order. The effect is in units of the deviation of the differences.
[[nodiscard]] TTest paired_test(std::span<const double> first, std::span<const double> second);

/// The smallest sample with which a test finds an `effect` (Cohen's d) with a power of 0.8: the number of people in
/// each of the two groups, or in the whole study if `paired`. Between 3 and 10 000; above 50 up to 2 % too high.
[[nodiscard]] int people_for_power(double effect, bool paired) noexcept;

}  // namespace telepalp::study
