#pragma once

#include "support/isosurface/isosurface.h"

namespace telepalp::isosurface {

/// What can be counted on a mesh.
struct MeshFacts {
  std::size_t open_edges = 0;  ///< edges that do not belong to exactly two triangles in opposite directions; 0: closed
  std::size_t parts = 0;       ///< pieces that share no point; a shell with a hollow inside has two
  long euler = 0;              ///< Euler number, points - edges + triangles: 2 for each ball, 0 for each ring
  double volume_m3 = 0.0;      ///< enclosed, if the mesh is closed
  std::size_t slivers = 0;     ///< triangles whose height is below a thousandth of their longest side
};
[[nodiscard]] MeshFacts facts_of(const Mesh& mesh);

}  // namespace telepalp::isosurface
