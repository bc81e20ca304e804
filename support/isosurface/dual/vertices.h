#pragma once

#include "support/isosurface/dual/pieces.h"

namespace telepalp::isosurface {

/// The vertex of each piece of surface, in its leaf: where the tangent planes at the crossings of its polygons meet;
/// where the surface bends smoothly, halfway from there to the surface. Error: `stop` was requested.
[[nodiscard]] Result<std::vector<Eigen::Vector3d>> vertices_of(const std::vector<Polygon>& polygons,
                                                               const Pieces& pieces, const CellTree& tree,
                                                               const Field& field, const std::stop_token& stop);

}  // namespace telepalp::isosurface
