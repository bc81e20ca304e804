#pragma once

#include <cstddef>
#include <vector>

namespace telepalp::bench {

/// Samples of one figure, with their quantiles.
class Distribution {
 public:
  void reserve(std::size_t count) { samples_.reserve(count); }
  void add(double sample) { samples_.push_back(sample); }
  [[nodiscard]] std::size_t count() const noexcept { return samples_.size(); }

  /// The smallest sample that is at least as large as a share `q` of all samples; NaN without samples.
  [[nodiscard]] double quantile(double q) const;
  [[nodiscard]] double p50() const { return quantile(0.5); }
  [[nodiscard]] double p99() const { return quantile(0.99); }
  [[nodiscard]] double p999() const { return quantile(0.999); }
  [[nodiscard]] double max() const { return quantile(1.0); }

 private:
  std::vector<double> samples_;
};

}  // namespace telepalp::bench
