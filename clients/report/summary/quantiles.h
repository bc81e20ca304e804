#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace telepalp::report {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();  ///< not measured; null in JSON

/// A distribution in a few numbers; kUnknown without samples.
struct Quantiles {
  double p50 = kUnknown;
  double p99 = kUnknown;
  double p999 = kUnknown;
  double most = kUnknown;
  std::size_t samples = 0;
};

/// By nearest rank. Samples that are not finite are left out.
[[nodiscard]] Quantiles quantiles(std::vector<double> samples);

}  // namespace telepalp::report
