#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace telepalp::study {

[[nodiscard]] double mean_of(std::span<const double> values) noexcept;  ///< 0 for an empty list
/// Spearman's rank correlation of two lists of equal length; equal values share their mean rank. 0 if one has no
/// spread.
[[nodiscard]] double rank_correlation(std::span<const double> one, std::span<const double> other);

/// A mean with its 95 % confidence interval.
struct Interval {
  double mean = 0.0;
  double low = 0.0;
  double high = 0.0;
};
/// Percentile bootstrap with 2000 resamples of `values`, one value for each operator. Operators are resampled, because
/// the penetrations of one operator are not independent of each other.
[[nodiscard]] Interval bootstrap(std::span<const double> values, std::uint64_t seed);

/// Values of all operators in one condition: `value[operator][configuration]`, configurations in the order of S4's
/// Table 1.
using Factorial = std::vector<std::vector<double>>;
/// Number of levels of linkage, phi, h and l_h.
inline constexpr std::array<int, 4> kLevels{3, 3, 2, 2};
inline constexpr std::array<const char*, 4> kFactors{"linkage", "phi", "h", "l_h"};

/// An effect: a main effect if `other` is -1, else an interaction of two factors.
struct Effect {
  int factor = 0;
  int other = -1;
  std::vector<double> means;  ///< of each level; of an interaction, of each pair of levels, row by row
  double spread = 0.0;        ///< root mean square of the effect, in the unit of the values
  double p = 1.0;
  [[nodiscard]] std::string name() const;
};

/// Main effects and interactions of two factors, by permutation tests with `permutations` shuffles. A main effect is
/// tested by shuffling its levels within each operator and each combination of the other factors. An interaction is
/// tested by shuffling, within each operator, the residuals of operator and main effects: an approximation. p is not
/// corrected for the number of tests.
[[nodiscard]] std::vector<Effect> effects_of(const Factorial& values, int permutations, std::uint64_t seed);

}  // namespace telepalp::study
