#pragma once

#include <span>
#include <vector>

namespace telepalp::plot {

/// Counts of values by bin; `edges` has one more entry than `counts`, ascending.
struct Histogram {
  std::vector<double> edges;
  std::vector<double> counts;
};

/// Bins of equal width on a logarithmic scale, `per_decade` each, that cover every finite positive value; values at or
/// below zero go to the lowest bin. Empty when no value is finite.
[[nodiscard]] Histogram logarithmic_histogram(std::span<const double> values, int per_decade);

}  // namespace telepalp::plot
