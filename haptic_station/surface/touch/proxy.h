#pragma once

#include <Eigen/Core>

namespace telepalp::surface {

/// A tangent plane of the surface: the proxy may be on it or on the side that `normal` (unit) points to.
struct ConstraintPlane {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

/// The point nearest to `device` that one constraint plane allows. Source: Salisbury and Tarr (1997), the goal of the
/// proxy is the device's projection on the tangent plane; a device on the free side is its own goal.
[[nodiscard]] Eigen::Vector3d goal_on_plane(const Eigen::Vector3d& device, const ConstraintPlane& plane) noexcept;

/// The point nearest to `device` that two constraint planes allow: on neither, one, or, in a crease, their line.
/// Planes nearly parallel count as the one that is farther out.
[[nodiscard]] Eigen::Vector3d goal_in_crease(const Eigen::Vector3d& device, const ConstraintPlane& first,
                                             const ConstraintPlane& second) noexcept;

}  // namespace telepalp::surface
