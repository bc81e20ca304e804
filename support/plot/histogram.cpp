#include "support/plot/histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/plot/scale.h"

namespace telepalp::plot {

Histogram logarithmic_histogram(std::span<const double> values, int per_decade) {
  constexpr double kLeast = 1e-6, kMost = 1e12;  // a stray value must not ask for a million bins
  std::vector<double> finite;
  for (const double value : values)
    if (std::isfinite(value)) finite.push_back(std::clamp(value, kLeast, kMost));
  if (finite.empty()) return {};
  std::vector<double> positive;
  for (const double value : finite)
    if (value > kLeast) positive.push_back(value);
  const Range range = range_of(positive, {1.0, 1.0});
  const int first = static_cast<int>(std::floor(std::log10(range.least) * per_decade));
  const int last = static_cast<int>(std::floor(std::log10(range.most) * per_decade));
  Histogram histogram;
  for (int edge = first; edge <= last + 1; ++edge)
    histogram.edges.push_back(std::pow(10.0, static_cast<double>(edge) / per_decade));
  histogram.counts.assign(histogram.edges.size() - 1, 0.0);
  for (const double value : finite) {
    const int bin = static_cast<int>(std::floor(std::log10(value) * per_decade)) - first;
    histogram.counts[static_cast<std::size_t>(std::clamp(bin, 0, last - first))] += 1.0;
  }
  return histogram;
}

}  // namespace telepalp::plot
