#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>

#include "clients/ar/mesh.h"

namespace telepalp::ar {

/// A signed distance, or anything that is negative inside and grows outwards.
using Field = std::function<float(const Eigen::Vector3f&)>;

/// The surface field = 0 within `box`, sampled every `cell_m`, normals from the field's gradient. White.
/// Source: Gibson, "Constrained elastic surface nets", 1998, without the relaxation.
[[nodiscard]] Mesh isosurface(const Field& field, const Eigen::AlignedBox3f& box, float cell_m);

}  // namespace telepalp::ar
