#include "support/isosurface/dual/vertices.h"

#include <algorithm>

namespace telepalp::isosurface {
namespace {

using Eigen::Vector3d;

constexpr double kBeyond = 0.5;  // a meeting point this far outside its leaf is moved to the leaf's border, in sides

/// The tangent planes of a bulge meet outside it, and the triangles between points of the surface run inside it.
/// Halfway, both errors cancel in the volume.
Vector3d halfway_to_surface(const Field& field, const Vector3d& at) {
  const FieldAt here = field.at(at);
  const double slope2 = here.gradient.squaredNorm();
  return slope2 > 0.1 ? Vector3d(at - 0.5 * here.m / slope2 * here.gradient) : at;
}

/// The meeting point of the planes in the box. If it lies far outside, fewer directions are used; the mean of the
/// planes' points lies in the box.
Vector3d vertex_in(const Eigen::AlignedBox3d& box, std::span<const Plane> planes, const Field& field) {
  for (int rank = 3; rank > 0; --rank) {
    const Meeting meeting = meeting_of(planes, rank);
    const Vector3d near = meeting.at.cwiseMax(box.min()).cwiseMin(box.max());
    if ((meeting.at - near).cwiseAbs().maxCoeff() > kBeyond * box.sizes().x()) continue;
    return meeting.rank == 1 ? halfway_to_surface(field, near) : near;
  }
  return meeting_of(planes, 0).at;
}

}  // namespace

Result<std::vector<Vector3d>> vertices_of(const std::vector<Polygon>& polygons, const Pieces& pieces,
                                          const CellTree& tree, const Field& field, const std::stop_token& stop) {
  std::vector<std::uint32_t> first(pieces.count + 1, 0);  // of each piece, in `planes`
  std::vector<std::int32_t> leaf(pieces.count);
  for (std::size_t p = 0; p < polygons.size(); ++p)
    for (std::size_t i = 0; i < polygons[p].corners; ++i) {
      ++first[pieces.vertex[4 * p + i] + 1];
      leaf[pieces.vertex[4 * p + i]] = polygons[p].leaf[i];
    }
  for (std::size_t i = 0; i < pieces.count; ++i) first[i + 1] += first[i];
  std::vector<Plane> planes(first.back());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t p = 0; p < polygons.size(); ++p)
    for (std::size_t i = 0; i < polygons[p].corners; ++i)
      planes[next[pieces.vertex[4 * p + i]]++] = polygons[p].crossing;
  std::vector<Vector3d> vertices(pieces.count);
  for (std::size_t i = 0; i < pieces.count; ++i) {
    if (stop.stop_requested()) return stopped();
    const Leaf& cell = tree.leaves()[static_cast<std::size_t>(leaf[i])];
    const Vector3d low = tree.lattice().at(cell.low);
    const double side_m = tree.lattice().step_m * tree.lattice().side(cell.level);
    vertices[i] = vertex_in({low, low + Vector3d::Constant(side_m)},
                            {planes.data() + first[i], planes.data() + first[i + 1]}, field);
  }
  return vertices;
}

}  // namespace telepalp::isosurface
