#pragma once

#include <Eigen/Core>

namespace telepalp::control {

/// `vector`, scaled down to `length` if it is longer.
[[nodiscard]] inline Eigen::Vector3d at_most(const Eigen::Vector3d& vector, double length) noexcept {
  const double norm = vector.norm();
  return norm > length ? Eigen::Vector3d(vector * (length / norm)) : vector;
}

}  // namespace telepalp::control
