#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace telepalp::report {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();  ///< not measured; written as null in JSON

/// `count` as a floating-point number; kUnknown if there is none.
[[nodiscard]] inline double known(const std::optional<std::uint64_t>& count) noexcept {
  return count ? static_cast<double>(*count) : kUnknown;
}

/// Quantiles of a distribution (p999: 99.9 %) and its largest sample (most); kUnknown without samples.
struct Quantiles {
  double p50 = kUnknown;
  double p99 = kUnknown;
  double p999 = kUnknown;
  double most = kUnknown;
  std::size_t samples = 0;
};

/// Quantiles by the nearest-rank method. Samples that are not finite are left out.
[[nodiscard]] Quantiles quantiles(std::vector<double> samples);

}  // namespace telepalp::report
