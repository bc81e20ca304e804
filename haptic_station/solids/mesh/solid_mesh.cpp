#include "haptic_station/solids/solid_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "haptic_station/solids/mesh/tree_field.h"

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;
using isosurface::Extraction;
using isosurface::Field;
using isosurface::Grid;

constexpr double kLargestCells = 24.0;   // along the solid's longest side
constexpr int kHalvings = 9;             // unless the smallest cell is given
constexpr double kSmallestLength = 2.3;  // two sheets are apart if they are this many cells apart
constexpr double kTouch_m = 1e-7;        // nearer sheets touch

Error refusal(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "mesh", .fix = std::move(fix)};
}

Result<Grid> grid_of(const SolidTree& tree) {
  const Box& box = tree.box();
  if (!box.bounded()) return refusal("the solid extends without end", "clip it, or intersect it with a box");
  return Grid{.box = {box.low, box.high}};
}

template <class... Values>
std::string text_of(const char* format, Values... values) {
  char text[320];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// The largest cells are halved without a remainder into the smallest.
void set_cells(Grid& grid, const MeshSettings& settings) {
  const double largest_m = grid.box.sizes().maxCoeff() / kLargestCells;
  grid.cell_m = largest_m;
  grid.halvings = kHalvings;
  if (!settings.smallest_cell_m) return;
  const double smallest_m = *settings.smallest_cell_m;
  grid.halvings =
      std::clamp(static_cast<int>(std::floor(std::log2(largest_m / smallest_m))), 0, isosurface::kMostHalvings);
  grid.cell_m = std::min(largest_m, std::ldexp(smallest_m, grid.halvings));
}

double smallest_m(const Grid& grid) { return std::ldexp(grid.cell_m, -grid.halvings); }

std::string cell_option(double cell_m) { return text_of("--cell-mm %.2g", 1e3 * cell_m); }

Error too_tight(const isosurface::Tight& tight, const Grid& grid) {
  const Vector3d& at = tight.at;
  if (tight.apart_m < kTouch_m)
    return refusal(text_of("parts of the solid touch near (%.4f, %.4f, %.4f) without joining", at.x(), at.y(), at.z()),
                   "move them apart, or let them overlap");
  return refusal(
      text_of("two sheets of the surface are %.3g mm apart near (%.4f, %.4f, %.4f), too near for cells of %.2g mm",
              1e3 * tight.apart_m, at.x(), at.y(), at.z(), 1e3 * smallest_m(grid)),
      "give smaller cells (" + cell_option(tight.apart_m / kSmallestLength) + "), or widen that gap or wall");
}

Error too_coarse(std::string what, const Grid& grid) {
  return refusal(std::move(what), "give smaller cells (" + cell_option(0.5 * smallest_m(grid)) +
                                      "), or make the solid's thinnest parts and sharpest edges blunter");
}

/// A second mesh, on cells moved against those of the first, has the same parts and Euler number.
Result<void> check_on_moved_cells(const Field& field, Grid grid, const CheckedMesh& made) {
  grid.offset = {.83, .12, .29};
  const Result<Extraction> other = extract(field, grid);
  if (!other) return other.error();
  const isosurface::MeshFacts facts = facts_of(other->mesh);
  if (facts.parts == made.facts.parts && facts.euler == made.facts.euler) return {};
  return too_coarse(
      text_of("two meshes with cells down to %.2g mm differ: %zu parts and Euler number %ld, or %zu and %ld",
              1e3 * smallest_m(grid), made.facts.parts, made.facts.euler, facts.parts, facts.euler),
      grid);
}

Result<void> check(const CheckedMesh& made, const Grid& grid) {
  if (made.facts.open_edges != 0)
    return refusal(std::to_string(made.facts.open_edges) + " edges of the mesh are open",
                   "this is a defect of telepalp: report it, with the scene file");
  if (made.mesh.triangles.empty() && !(made.volume.m3 > 0.0))
    return refusal("the solid is empty: it encloses no volume",
                   "check its intersections, differences and clips: their operands may not meet");
  const double off_m3 = std::abs(made.facts.volume_m3 - made.volume.m3);
  if (!(off_m3 <= kMostVolumeError * made.volume.m3 + 3.0 * made.volume.error_m3))
    return too_coarse(
        text_of("the mesh encloses %.4g cm3, the solid %.4g cm3", 1e6 * made.facts.volume_m3, 1e6 * made.volume.m3),
        grid);
  return {};
}

}  // namespace

Result<SolidMesh> mesh_of(const SolidTree& tree, double cell_m, const std::stop_token& stop) {
  Result<Grid> grid = grid_of(tree);
  if (!grid) return grid.error();
  grid->cell_m = cell_m;
  grid->examine = false;
  grid->stop = stop;
  Result<Extraction> made = extract(field_of(tree), *grid);
  if (!made) return made.error();
  return std::move(made->mesh);
}

Result<CheckedMesh> checked_mesh_of(const SolidTree& tree, const MeshSettings& settings) {
  Result<Grid> grid = grid_of(tree);
  if (!grid) return grid.error();
  set_cells(*grid, settings);
  grid->most_cells = settings.most_cells;
  grid->progress = settings.progress;
  const Field field = field_of(tree);
  Result<Extraction> extracted = extract(field, *grid);
  if (!extracted) {
    Error error = extracted.error();
    error.where = "mesh";
    error.fix = "give a larger smallest cell (" + cell_option(2.0 * smallest_m(*grid)) +
                " or more), widen the thinnest wall or gap there, or divide the layer";
    return error;
  }
  if (extracted->tightest) return too_tight(*extracted->tightest, *grid);
  CheckedMesh made{.mesh = std::move(extracted->mesh),
                   .facts = {},
                   .volume = volume_of(field, grid->box),
                   .finest_m = extracted->finest_m,
                   .meshed_twice = extracted->unsure > 0};
  made.facts = facts_of(made.mesh);
  if (const Result<void> checked = check(made, *grid); !checked) return checked.error();
  if (!made.meshed_twice) return made;
  if (const Result<void> same = check_on_moved_cells(field, *grid, made); !same) return same.error();
  return made;
}

}  // namespace telepalp::solids
