#include "haptic_station/tracking/sample_noise.h"

#include <algorithm>
#include <cmath>

namespace telepalp::tracking {
namespace {

constexpr double kFloor_m2 = 1e-10;  // added to squared innovations: 10 um is below any tracker's resolution
constexpr double kWeighting = 1.5;   // for Gaussian noise: undoes the bias of the weights, which favour small products

}  // namespace

void SampleNoise::begin_movement(const Eigen::Vector3d& sample_m) noexcept {
  last_m_ = sample_m;
  samples_ = 1;
}

void SampleNoise::add(const Eigen::Vector3d& sample_m, double dt_s) noexcept {
  const Eigen::Vector3d innovation_m = sample_m - last_m_ - dt_s * step_m_per_s_;
  const double ratio = dt_s_ > 0.0 ? dt_s / dt_s_ : 1.0;
  if (samples_ >= 3) {
    const double forget = std::exp(-dt_s / memory_s_);
    // Samples with small innovations count most: they show the noise alone.
    const double weight = 1.0 / (innovation_m.squaredNorm() + innovation_m_.squaredNorm() + kFloor_m2);
    covariance_ = forget * covariance_ - weight * innovation_m.dot(innovation_m_) / 3.0;
    share_ = forget * share_ + weight * ((1.0 + ratio) + ratio * (1.0 + ratio_));
    variance_m2_ = kWeighting * std::max(0.0, covariance_ / share_);
  }
  samples_ = std::min(samples_ + 1, 3);
  step_m_per_s_ = (sample_m - last_m_) / dt_s;
  innovation_m_ = innovation_m;
  last_m_ = sample_m;
  dt_s_ = dt_s;
  ratio_ = ratio;
}

}  // namespace telepalp::tracking
