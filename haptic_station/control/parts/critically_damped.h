#pragma once

#include <Eigen/Core>
#include <cmath>

namespace telepalp::control {

/// A vector [m] and its rate of change [m/s].
struct Moving {
  Eigen::Vector3d m = Eigen::Vector3d::Zero();
  Eigen::Vector3d per_s = Eigen::Vector3d::Zero();
};

/// `moving` after `dt_s` of a critically damped approach to zero; exact for any step length.
[[nodiscard]] inline Moving toward_zero(const Moving& moving, double omega_rad_per_s, double dt_s) noexcept {
  const double decay = std::exp(-omega_rad_per_s * dt_s);
  const Eigen::Vector3d slope = moving.per_s + omega_rad_per_s * moving.m;
  Moving later;
  later.m = (moving.m + slope * dt_s) * decay;
  later.per_s = (moving.per_s - omega_rad_per_s * slope * dt_s) * decay;
  return later;
}

}  // namespace telepalp::control
