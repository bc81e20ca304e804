#pragma once

#include "clients/ar/mesh.h"

namespace telepalp::ar {

/// A ball of `radius_m` around `centre`, white.
[[nodiscard]] Mesh ball(const Eigen::Vector3f& centre, float radius_m);

/// A cone cut off at both ends, from `from` (radius `from_radius_m`) to `to`, closed, white. A rod when the radii
/// agree. Empty when both ends coincide.
[[nodiscard]] Mesh frustum(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float from_radius_m,
                           float to_radius_m);

/// An arrow from `from` to `to`, shaft of `radius_m`, white. Shorter than its head: only the head.
[[nodiscard]] Mesh arrow(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius_m);

}  // namespace telepalp::ar
