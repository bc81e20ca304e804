#pragma once

#include "support/isosurface/cells/cell_tree.h"
#include "support/isosurface/cells/planes.h"

namespace telepalp::isosurface {

/// The face of the surface's mesh around an edge of the octree that crosses the surface: its corners are the three or
/// four leaves around the edge, counter-clockwise from outside.
struct Polygon {
  std::array<std::int32_t, 4> leaf{};
  std::size_t corners = 0;
  Plane crossing;            ///< where the octree's edge meets the surface, with the surface's normal
  Eigen::Vector3d outwards;  ///< along the octree's edge, from inside to outside

  [[nodiscard]] std::size_t after(std::size_t corner) const noexcept { return corner + 1 == corners ? 0 : corner + 1; }
};

/// One polygon for each shortest edge of the octree whose ends lie on two sides of the surface. Error: a leaf beside
/// such an edge is missing, because the field is steeper than it says;
/// or `stop` was requested.
[[nodiscard]] Result<std::vector<Polygon>> polygons_of(const CellTree& tree, const Field& field,
                                                       const std::stop_token& stop);

}  // namespace telepalp::isosurface
