#pragma once

#include "clients/ar/mesh.h"

namespace telepalp::ar {

/// A white ball of `radius_m` around `centre`.
[[nodiscard]] Mesh ball(const Eigen::Vector3f& centre, float radius_m);

/// A closed white frustum of a cone from `from` (radius `from_radius_m`) to `to` (radius `to_radius_m`); with equal
/// radii it is a cylinder. Empty when both ends coincide.
[[nodiscard]] Mesh frustum(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float from_radius_m,
                           float to_radius_m);

/// A white arrow from `from` to `to` with a shaft of `radius_m`. An arrow shorter than its head is a head alone. Empty
/// when both ends coincide.
[[nodiscard]] Mesh arrow(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius_m);

}  // namespace telepalp::ar
