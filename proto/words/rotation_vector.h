#pragma once

#include <Eigen/Geometry>

namespace telepalp {

/// The rigid motion of a rotation vector (axis times angle) and a translation.
[[nodiscard]] inline Eigen::Isometry3d isometry_of(const Eigen::Vector3d& rotation_vector_rad,
                                                   const Eigen::Vector3d& translation_m) {
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  const double angle_rad = rotation_vector_rad.norm();
  if (angle_rad > 0.0)
    isometry.linear() = Eigen::AngleAxisd(angle_rad, rotation_vector_rad.normalized()).toRotationMatrix();
  isometry.translation() = translation_m;
  return isometry;
}

}  // namespace telepalp
