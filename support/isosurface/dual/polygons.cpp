#include "support/isosurface/dual/polygons.h"

#include <algorithm>

namespace telepalp::isosurface {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr int kMostRounds = 24;
constexpr double kOnSurface = 1e-6;  // of the edge's length

/// Where the edge from `inside` to `outside` meets the surface: regula falsi (Illinois).
Plane crossing_of(const Field& field, const Vector3d& inside, const Vector3d& outside) {
  const Vector3d along = outside - inside;
  const double close_m = kOnSurface * along.norm();
  double low = 0.0, high = 1.0;
  double low_m = field.m_at(inside), high_m = field.m_at(outside);
  double share = 0.5;
  for (int round = 0; round < kMostRounds; ++round) {
    share = low - low_m * (high - low) / (high_m - low_m);
    const double m = field.m_at(inside + share * along);
    if (std::abs(m) <= close_m) break;
    (m < 0.0 ? low : high) = share;
    (m < 0.0 ? low_m : high_m) = m;
    (m < 0.0 ? high_m : low_m) *= 0.5;
  }
  FieldAt at = field.at(inside + share * along);
  constexpr double kTie = 0.3;  // a shorter gradient: opposite parts of the solid give the value together
  if (at.gradient.norm() < kTie) at = field.at(inside + (share + 1e-3) * along);
  const double slope = at.gradient.norm();
  return {inside + share * along, slope > 0.0 ? Vector3d(at.gradient / slope) : Vector3d(along.normalized())};
}

class Edges {
 public:
  Edges(const CellTree& tree, const Field& field) : tree_(tree), field_(field) {}

  /// False: a leaf beside an edge is missing.
  bool of_leaf(std::int32_t index) {
    const Leaf& leaf = tree_.leaves()[static_cast<std::size_t>(index)];
    if (leaf.inside == 0 || leaf.inside == 0xff) return true;
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 4; ++side)
        if (!edge(index, leaf, axis, side)) return false;
    return true;
  }
  std::vector<Polygon> take() { return std::move(polygons_); }

 private:
  bool edge(std::int32_t index, const Leaf& leaf, int axis, int side) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int low_corner = (side & 1) << u | (side >> 1) << v;
    const bool low_inside = (leaf.inside >> low_corner & 1) != 0;
    if (low_inside == ((leaf.inside >> (low_corner | 1 << axis) & 1) != 0)) return true;
    const int length = tree_.lattice().side(leaf.level);
    const Vector3i node = leaf.low + length * corner(low_corner);
    constexpr std::array<std::array<int, 2>, 4> kAround{{{-1, -1}, {0, -1}, {0, 0}, {-1, 0}}};
    std::array<std::int32_t, 4> around{};
    for (std::size_t i = 0; i < 4; ++i) {
      Vector3i low = node;
      low[u] += length * kAround[i][0];
      low[v] += length * kAround[i][1];
      around[i] = low.minCoeff() < 0 ? CellTree::kAbsent : tree_.leaf_over(low, leaf.level);
      if (around[i] == CellTree::kDivided) return true;  // smaller leaves have parts of this edge
      if (around[i] == CellTree::kAbsent) return false;
      const bool same_size = tree_.leaves()[static_cast<std::size_t>(around[i])].level == leaf.level;
      if (same_size && around[i] < index) return true;  // that leaf has given the polygon
    }
    if (!low_inside) std::ranges::reverse(around);
    add(around, node, length * Vector3i::Unit(axis), low_inside);
    return true;
  }

  void add(const std::array<std::int32_t, 4>& around, const Vector3i& node, const Vector3i& along, bool low_inside) {
    Polygon polygon;
    for (std::size_t i = 0; i < 4; ++i)  // a large leaf may lie on two sides of the edge
      if (around[i] != around[(i + 3) % 4]) polygon.leaf[polygon.corners++] = around[i];
    const Vector3d low = tree_.lattice().at(node), high = tree_.lattice().at(node + along);
    polygon.crossing = low_inside ? crossing_of(field_, low, high) : crossing_of(field_, high, low);
    polygon.outwards = (low_inside ? high - low : low - high).normalized();
    polygons_.push_back(polygon);
  }

  const CellTree& tree_;
  const Field& field_;
  std::vector<Polygon> polygons_;
};

}  // namespace

Result<std::vector<Polygon>> polygons_of(const CellTree& tree, const Field& field, const std::stop_token& stop) {
  Edges edges(tree, field);
  for (std::size_t i = 0; i < tree.leaves().size(); ++i) {
    if (stop.stop_requested()) return stopped();
    if (!edges.of_leaf(static_cast<std::int32_t>(i)))
      return Error{.what =
                       "the surface leaves the cells in which it was expected: its function is steeper than stated, "
                       "or the surface is not closed within its box",
                   .where = "isosurface",
                   .fix = "this is a defect of telepalp: report it, with the scene file"};
  }
  return edges.take();
}

}  // namespace telepalp::isosurface
