#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>

#include "clients/ar/mesh.h"

namespace telepalp::ar {

/// An implicit function: negative inside, increasing outwards, for example a signed distance.
using Field = std::function<float(const Eigen::Vector3f&)>;

/// Extracts the surface field = 0 within `box` on a grid of `cell_m`, with normals from the field's gradient. The mesh
/// is white.
/// Source: Gibson, "Constrained elastic surface nets", 1998, without the relaxation.
[[nodiscard]] Mesh isosurface(const Field& field, const Eigen::AlignedBox3f& box, float cell_m);

}  // namespace telepalp::ar
