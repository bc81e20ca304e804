#pragma once

#include <Eigen/Geometry>
#include <optional>

namespace telepalp::tracking {

/// The rotation from the hand's axes to a tracker's frame, from two directions that the tracker measures: along the
/// fingers, and out of the palm. The hand's axes: x to the little finger of a right hand, y along the fingers, z out of
/// the back of the hand. The directions need not be unit or exactly perpendicular. nullopt: one is not finite or
/// shorter than 0.1, or they are parallel within 6 degrees.
[[nodiscard]] inline std::optional<Eigen::Quaterniond> hand_axes(const Eigen::Vector3d& fingers,
                                                                 const Eigen::Vector3d& out_of_palm) noexcept {
  constexpr double kLeast = 0.1;
  if (!fingers.allFinite() || !out_of_palm.allFinite()) return std::nullopt;
  if (fingers.norm() < kLeast || out_of_palm.norm() < kLeast) return std::nullopt;
  const Eigen::Vector3d z = -out_of_palm.normalized();
  const Eigen::Vector3d along = fingers.normalized();
  const Eigen::Vector3d y = along - along.dot(z) * z;
  if (y.norm() < kLeast) return std::nullopt;
  Eigen::Matrix3d axes;
  axes << y.normalized().cross(z), y.normalized(), z;
  return Eigen::Quaterniond(axes);
}

}  // namespace telepalp::tracking
