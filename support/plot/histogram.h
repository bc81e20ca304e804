#pragma once

#include <span>
#include <vector>

namespace telepalp::plot {

/// Number of values per bin. `edges` ascends and has one more entry than `counts`.
struct Histogram {
  std::vector<double> edges;
  std::vector<double> counts;
};

/// A histogram with `per_decade` logarithmic bins per decade that cover all values from 1e-6 to 1e12. Smaller values,
/// also those <= 0, are counted in the lowest bin, larger ones as 1e12. Empty when no value is finite.
[[nodiscard]] Histogram logarithmic_histogram(std::span<const double> values, int per_decade);

}  // namespace telepalp::plot
