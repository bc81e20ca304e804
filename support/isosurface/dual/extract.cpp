#include "support/isosurface/isosurface.h"

#include <cmath>

#include "proto/words/demand.h"
#include "support/isosurface/dual/triangles.h"
#include "support/isosurface/dual/vertices.h"

namespace telepalp::isosurface {

Result<Extraction> extract(const Field& field, const Grid& grid) {
  demand(grid.halvings >= 0 && grid.halvings <= kMostHalvings && grid.cell_m > 0.0, "a grid has cells");
  const Eigen::Vector3d cells = (grid.box.sizes() / grid.cell_m).array().ceil() + 3.0;  // a cell more on each side
  const Lattice lattice{.origin = grid.box.min() - grid.cell_m * (Eigen::Vector3d::Constant(1.0) + grid.offset),
                        .step_m = std::ldexp(grid.cell_m, -1 - grid.halvings),
                        .halvings = grid.halvings};
  if (!(cells.maxCoeff() * lattice.side(0) < std::ldexp(1.0, kCoordinateBits)))
    return Error{.what = "the box is more than a million smallest half cells long",
                 .where = "isosurface",
                 .fix = "use larger cells"};
  const Result<Refined> refined = refine(field, grid, lattice, cells.cast<int>());
  if (!refined) return refined.error();
  const CellTree& tree = refined->tree;
  const Result<std::vector<Polygon>> polygons = polygons_of(tree, field, grid.stop);
  if (!polygons) return polygons.error();
  const Pieces pieces = pieces_of(*polygons, tree, field);
  Result<std::vector<Eigen::Vector3d>> vertices = vertices_of(*polygons, pieces, tree, field, grid.stop);
  if (!vertices) return vertices.error();
  Extraction out{.mesh = triangulated(*polygons, pieces, std::move(vertices).value()),
                 .tightest = refined->tightest,
                 .unsure = refined->unsure,
                 .cells = tree.leaves().size(),
                 .finest_m = grid.cell_m};
  for (const Leaf& leaf : tree.leaves()) out.finest_m = std::min(out.finest_m, std::ldexp(grid.cell_m, -leaf.level));
  return out;
}

}  // namespace telepalp::isosurface
