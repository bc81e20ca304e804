#pragma once

#include <string>

#include "haptic_station/solids/solid_tree.h"

namespace telepalp::solids {

/// A closed surface of triangles, counter-clockwise from outside.
struct SolidMesh {
  std::vector<Eigen::Vector3d> points;  ///< [m], in the solid's frame
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

inline constexpr std::size_t kMostCells = 64'000'000;

/// The surface of a solid, by marching cubes of side `cell_m`, each cut into six tetrahedra (Doi and Koide 1991): no
/// case is ambiguous, so each edge belongs to exactly two triangles. Parts thinner than `cell_m` may be missing. Error:
/// the solid has no bounds, or its box has more than kMostCells cubes.
[[nodiscard]] Result<SolidMesh> mesh_of(const SolidTree& tree, double cell_m);

/// The number of edges that do not belong to exactly two triangles with opposite directions; 0: watertight.
[[nodiscard]] std::size_t open_edges(const SolidMesh& mesh);

/// The mesh as the text of an ASCII PLY or a Wavefront OBJ file, in metres.
[[nodiscard]] std::string to_ply(const SolidMesh& mesh);
[[nodiscard]] std::string to_obj(const SolidMesh& mesh);

}  // namespace telepalp::solids
