#pragma once

#include <span>
#include <vector>

namespace telepalp::plot {

/// Number of values per bin. `edges` ascends and has one more entry than `counts`.
struct Histogram {
  std::vector<double> edges;
  std::vector<double> counts;
};

/// A histogram of the finite values. Its logarithmic bins, `per_decade` in a decade, reach from the least value above
/// 1e-6 to the greatest. Values up to 1e-6 count in the lowest bin, values over 1e12 as 1e12. Empty if none is finite.
[[nodiscard]] Histogram logarithmic_histogram(std::span<const double> values, int per_decade);

}  // namespace telepalp::plot
