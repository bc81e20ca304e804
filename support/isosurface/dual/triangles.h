#pragma once

#include "support/isosurface/dual/pieces.h"

namespace telepalp::isosurface {

/// The polygons cut into triangles. `vertices`: of the pieces.
[[nodiscard]] Mesh triangulated(const std::vector<Polygon>& polygons, const Pieces& pieces,
                                std::vector<Eigen::Vector3d> vertices);

}  // namespace telepalp::isosurface
