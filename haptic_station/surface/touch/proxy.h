#pragma once

#include <Eigen/Core>

namespace telepalp::surface {

/// A tangent plane of the surface at the point `at` [m]. The proxy stays on the plane or on the side to which `normal`
/// (unit) points. The points and planes of one call are all in one frame.
struct ConstraintPlane {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

/// The point nearest to `device` that one constraint plane allows: the projection of `device` on the plane, or
/// `device` itself where it lies on the side of the normal. Source: the goal of the proxy in Salisbury and Tarr (1997).
[[nodiscard]] Eigen::Vector3d goal_on_plane(const Eigen::Vector3d& device, const ConstraintPlane& plane) noexcept;

/// The point nearest to `device` that two constraint planes allow: on no plane, on one plane, or, in a crease, on
/// the line where both planes meet. Of two nearly parallel planes, only the one that is higher above the device
/// counts.
[[nodiscard]] Eigen::Vector3d goal_in_crease(const Eigen::Vector3d& device, const ConstraintPlane& first,
                                             const ConstraintPlane& second) noexcept;

}  // namespace telepalp::surface
