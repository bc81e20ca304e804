#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/study/figures/statistics.h"

namespace telepalp::study {

/// A cell of S4's Table 2: overshoot and its standard deviation [mm]. In the order of amniocentesis_design(). S4 does
/// not say over what the deviation is taken: the 20 penetrations, or the means of the 4 subjects.
struct PaperCell {
  double overshoot_mm;
  double deviation_mm;
};
[[nodiscard]] const std::array<PaperCell, 36>& paper_table() noexcept;
[[nodiscard]] std::vector<double> paper_overshoots_mm();

/// Rank correlation with Table 2 that a perfect model would have on average, if each cell has the standard error
/// deviation / sqrt(`of`). The true table is estimated by shrinking the measured one towards its mean by its
/// reliability.
[[nodiscard]] double noise_ceiling(double of, std::uint64_t seed);

/// A pattern that S4 reads from its Table 2, looked up in that table and in another one.
struct Pattern {
  std::string what;
  std::string in_paper;    ///< the figures of the pattern in Table 2
  std::string here;        ///< the same figures in the other table
  bool holds = false;      ///< in the means over all operators
  double certainty = 1.0;  ///< share of the resamples of the operators in which it holds
};
/// "appears" if it holds in at least 95 % of the resamples, "does not appear" if in at most 5 %, else "not certain".
[[nodiscard]] std::string_view verdict(const Pattern& pattern) noexcept;

/// `overshoots_mm`: 36 means in the order of amniocentesis_design().
[[nodiscard]] std::vector<Pattern> patterns_of(std::span<const double> overshoots_mm);
/// As above, for the means over the operators; 1000 resamples of the operators give the certainty.
[[nodiscard]] std::vector<Pattern> patterns_of(const Factorial& by_operator, std::uint64_t seed);

}  // namespace telepalp::study
