#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace telepalp::calibration {

/// Distances of the measurements from a fitted model [m]. deviation_m(): their sample standard deviation (n - 1).
struct Residuals {
  std::vector<double> each_m;

  [[nodiscard]] double mean_m() const noexcept {
    double sum = 0.0;
    for (const double r : each_m) sum += r;
    return each_m.empty() ? 0.0 : sum / static_cast<double>(each_m.size());
  }
  [[nodiscard]] double deviation_m() const noexcept {
    double sum = 0.0;
    for (const double mean = mean_m(); const double r : each_m) sum += (r - mean) * (r - mean);
    return each_m.size() < 2 ? 0.0 : std::sqrt(sum / static_cast<double>(each_m.size() - 1));
  }
  [[nodiscard]] double rms_m() const noexcept {
    double sum = 0.0;
    for (const double r : each_m) sum += r * r;
    return each_m.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(each_m.size()));
  }
  /// Index of the largest residual; 0 when there are no residuals.
  [[nodiscard]] std::size_t worst() const noexcept {
    return static_cast<std::size_t>(std::max_element(each_m.begin(), each_m.end()) - each_m.begin());
  }
  [[nodiscard]] double largest_m() const noexcept { return each_m.empty() ? 0.0 : each_m[worst()]; }
};

}  // namespace telepalp::calibration
