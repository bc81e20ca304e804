#pragma once

#include "support/isosurface/dual/polygons.h"

namespace telepalp::isosurface {

/// How the polygons join. Their corners are numbered 4 * polygon + corner, and each side has its first corner's number.
struct Pieces {
  std::vector<std::uint32_t> vertex;  ///< of each corner: index of the piece of surface in the leaf, 0 to `count` - 1
  std::vector<std::int32_t> middle;   ///< of each side: index of a point halfway, shared by two sides; -1: none needed
  std::size_t count = 0;              ///< pieces
  std::vector<Eigen::Vector3d> middles;
};

/// Joins the polygons across the faces between leaves, each side with exactly one other. Where more than two sides lie
/// on one face, the field at the face's middle decides which of them belong together. The corners at a leaf that are
/// joined so form rings; each ring is one piece of surface with one vertex, so the mesh is a manifold.
[[nodiscard]] Pieces pieces_of(const std::vector<Polygon>& polygons, const CellTree& tree, const Field& field);

}  // namespace telepalp::isosurface
