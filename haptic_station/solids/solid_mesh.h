#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "haptic_station/solids/solid_tree.h"
#include "support/isosurface/field_volume.h"
#include "support/isosurface/isosurface.h"
#include "support/isosurface/mesh_facts.h"

namespace telepalp::solids {

/// A closed surface of triangles, counter-clockwise from outside; points in metres, in the solid's frame.
using SolidMesh = isosurface::Mesh;

/// The surface of a solid for pictures, on cells of one size (isosurface::extract() without halving). It is closed, but
/// parts thinner than `cell_m` may be missing. Error: the solid has no bounds, the surface needs too many cells, or
/// `stop` was requested.
[[nodiscard]] Result<SolidMesh> mesh_of(const SolidTree& tree, double cell_m, const std::stop_token& stop = {});

struct MeshSettings {
  std::optional<double> smallest_cell_m{};  ///< nullopt: 1/12 000 of the solid's longest side
  std::size_t most_cells = 2'000'000;       ///< as Grid::most_cells
  std::function<void(double)> progress{};   ///< as Grid::progress
};

/// A mesh that has been checked.
struct CheckedMesh {
  SolidMesh mesh;
  isosurface::MeshFacts facts;
  isosurface::Volume volume;  ///< of the solid itself
  double finest_m = 0.0;      ///< side of the smallest cell used
  bool meshed_twice = false;  ///< the smallest cells left doubt, and a second mesh on moved cells has the same shape
};

/// The surface of a solid, with cells as small as the solid's parts, gaps and walls need (isosurface::extract()), or
/// the reason why there is no right mesh. Error: the solid has no bounds or is empty; its surface needs too many cells;
/// two of its sheets are too near to each other for the smallest cells, or touch; or the mesh fails a check: each edge
/// belongs to two triangles, its volume is that of the solid within kMostVolumeError, and, in doubt, a second mesh on
/// other cells has the same number of parts and the same Euler number. The error states the smallest cell that would
/// do.
[[nodiscard]] Result<CheckedMesh> checked_mesh_of(const SolidTree& tree, const MeshSettings& settings = {});
inline constexpr double kMostVolumeError = 0.01;

/// The mesh as the text of an ASCII PLY or a Wavefront OBJ file, in metres.
[[nodiscard]] std::string to_ply(const SolidMesh& mesh);
[[nodiscard]] std::string to_obj(const SolidMesh& mesh);

}  // namespace telepalp::solids
