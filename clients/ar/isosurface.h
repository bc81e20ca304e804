#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>

#include "clients/ar/mesh.h"

namespace telepalp::ar {

/// An implicit function: negative inside, and about the distance to the surface, in any unit.
using Field = std::function<float(const Eigen::Vector3f&)>;
inline constexpr double kSteepest = 1.5;  ///< greatest slope of a field

/// The surface field = 0, which must be closed within `box`, on cells of side `cell`, with normals from the field's
/// gradient. The mesh is white. An adapter of isosurface::extract().
[[nodiscard]] Mesh isosurface(const Field& field, const Eigen::AlignedBox3f& box, float cell);

}  // namespace telepalp::ar
