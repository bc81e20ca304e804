#include "haptic_station/tissue/fem/prism_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace telepalp::tissue {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr std::size_t kMostNodes = 4000;
const char* const kWhere = "prism";

/// Nodes of a lattice, numbered level by level from the bottom, so that those of the bottom come first.
class Lattice {
 public:
  explicit Lattice(const PrismGrid& grid)
      : steps_(grid.order == ElementOrder::Quadratic ? 2 : 1),
        last_(steps_ * Vector3i(grid.across, grid.along, grid.across)),
        size_m_(grid.size_m),
        grading_(grid.grading) {}
  /// Lattice steps in a cell: 2 if the middles of its edges are nodes.
  [[nodiscard]] int steps() const { return steps_; }
  [[nodiscard]] const Vector3i& last() const { return last_; }
  [[nodiscard]] std::uint32_t node(const Vector3i& at) const {
    return static_cast<std::uint32_t>((at.y() * (last_.z() + 1) + at.z()) * (last_.x() + 1) + at.x());
  }
  [[nodiscard]] std::vector<Vector3d> places() const {
    std::vector<Vector3d> all;
    for (int y = 0; y <= last_.y(); ++y)
      for (int z = 0; z <= last_.z(); ++z)
        for (int x = 0; x <= last_.x(); ++x) {
          const Vector3d share(static_cast<double>(x) / last_.x(), height(y), static_cast<double>(z) / last_.z());
          all.emplace_back((share - Vector3d(0.5, 0.0, 0.5)).cwiseProduct(size_m_));
        }
    return all;
  }

 private:
  /// Of a level, over that of the prism; levels within a cell are in its middle.
  [[nodiscard]] double height(int level) const {
    const auto end = [&](int of) { return std::pow(static_cast<double>(of) / last_.y(), grading_); };
    return 0.5 * (end(level - level % steps_) + end(level + level % steps_));
  }
  int steps_;
  Vector3i last_;
  Vector3d size_m_;
  double grading_;
};

/// The six tetrahedra of Kuhn: each walks from the cell's lowest corner to its highest along the three axes in another
/// order. Neighbouring cells meet in the same diagonals.
void add_cell(const Lattice& lattice, const Vector3i& lowest, TetMesh& mesh) {
  std::array<int, 3> axes{0, 1, 2};
  do {
    std::array<Vector3i, 4> corners{lowest};
    for (std::size_t i = 0; i < 3; ++i) corners[i + 1] = corners[i] + lattice.steps() * Vector3i::Unit(axes[i]);
    const bool even = (axes[0] + 1) % 3 == axes[1];
    if (!even) std::swap(corners[1], corners[2]);  // the same tetrahedron, right side out
    std::array<std::uint32_t, 10> nodes{};
    for (std::size_t i = 0; i < 4; ++i) nodes[i] = lattice.node(corners[i]);
    if (mesh.order == ElementOrder::Quadratic)
      for (std::size_t e = 0; e < 6; ++e)
        nodes[4 + e] = lattice.node((corners[kTetrahedronEdges[e][0]] + corners[kTetrahedronEdges[e][1]]) / 2);
    mesh.tetrahedra.push_back(nodes);
  } while (std::ranges::next_permutation(axes).found);
}

SideTriangle side_triangle(const Lattice& lattice, const std::array<Vector3i, 3>& corners) {
  SideTriangle nodes{};
  for (std::size_t i = 0; i < 3; ++i) {
    nodes[i] = lattice.node(corners[i]);
    if (lattice.steps() == 2) nodes[3 + i] = lattice.node((corners[i] + corners[(i + 1) % 3]) / 2);
  }
  return nodes;
}

/// Two triangles for each cell's face, on the diagonal on which its tetrahedra meet. `u` × `v` must point outwards.
void add_side(const Lattice& lattice, const Vector3i& from, const Vector3i& u, const Vector3i& v,
              std::vector<SideTriangle>& side) {
  const int step = lattice.steps();
  for (int i = 0; i < lattice.last().dot(u); i += step)
    for (int j = 0; j < lattice.last().dot(v); j += step) {
      const Vector3i at = from + i * u + j * v;
      const Vector3i across = at + step * (u + v);
      side.push_back(side_triangle(lattice, {at, at + step * u, across}));
      side.push_back(side_triangle(lattice, {at, across, at + step * v}));
    }
}

void add_sides(const Lattice& lattice, TetMesh& mesh) {
  const Vector3i x = Vector3i::UnitX();
  const Vector3i y = Vector3i::UnitY();
  const Vector3i z = Vector3i::UnitZ();
  const Vector3i& last = lattice.last();
  auto side = [&](PrismSide one) -> auto& { return mesh.sides[static_cast<std::size_t>(one)]; };
  add_side(lattice, Vector3i::Zero(), z, y, side(PrismSide::Left));
  add_side(lattice, {last.x(), 0, 0}, y, z, side(PrismSide::Right));
  add_side(lattice, Vector3i::Zero(), y, x, side(PrismSide::Back));
  add_side(lattice, {0, 0, last.z()}, x, y, side(PrismSide::Front));
  add_side(lattice, {0, last.y(), 0}, z, x, side(PrismSide::Top));
}

Result<void> check_grid(const PrismGrid& grid) {
  if (!((grid.size_m.array() >= 0.002).all() && (grid.size_m.array() <= 1.0).all()))
    return Error{.what = "a side of the prism is not a number, below 2 mm or above 1 m",
                 .where = kWhere,
                 .fix = "give 0.002 to 1 m for each side"};
  if (grid.across < 1 || grid.across > 16 || grid.along < 1 || grid.along > 64)
    return Error{.what = "the prism has " + std::to_string(grid.across) + " cells across and " +
                         std::to_string(grid.along) + " along",
                 .where = kWhere,
                 .fix = "give 1 to 16 cells across and 1 to 64 along"};
  const auto steps = static_cast<std::size_t>(grid.order == ElementOrder::Quadratic ? 2 : 1);
  const std::size_t wide = steps * static_cast<std::size_t>(grid.across) + 1;
  const std::size_t nodes = wide * wide * (steps * static_cast<std::size_t>(grid.along) + 1);
  if (nodes > kMostNodes)
    return Error{.what = "the prism has " + std::to_string(nodes) + " nodes",
                 .where = kWhere,
                 .fix = "give fewer cells: at most " + std::to_string(kMostNodes) + " nodes"};
  return {};
}

/// Six times the volume of a tetrahedron over the cube of its longest edge; 1 / sqrt(2) if it is regular. NaN: an edge
/// without length, or a node that is not a number.
double shape_of(const TetMesh& mesh, const std::array<std::uint32_t, 10>& nodes) {
  const Vector3d& origin = mesh.nodes[nodes[0]];
  Eigen::Matrix3d edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = mesh.nodes[nodes[static_cast<std::size_t>(i) + 1]] - origin;
  double longest_m = 0.0;
  for (const auto& [a, b] : kTetrahedronEdges) {
    const double length_m = (mesh.nodes[nodes[a]] - mesh.nodes[nodes[b]]).norm();
    if (!(length_m > 0.0)) return std::numeric_limits<double>::quiet_NaN();
    longest_m = std::max(longest_m, length_m);
  }
  return edges.determinant() / (longest_m * longest_m * longest_m);
}

}  // namespace

Result<TetMesh> make_prism(const PrismGrid& grid) {
  if (auto right = check_grid(grid); !right) return right.error();
  const Lattice lattice(grid);
  TetMesh mesh{.order = grid.order, .nodes = lattice.places(), .tetrahedra = {}, .sides = {}};
  mesh.fixed = lattice.node({0, 1, 0});
  for (int y = 0; y < grid.along; ++y)
    for (int z = 0; z < grid.across; ++z)
      for (int x = 0; x < grid.across; ++x) add_cell(lattice, lattice.steps() * Vector3i(x, y, z), mesh);
  add_sides(lattice, mesh);
  return mesh;
}

Result<void> check(const TetMesh& mesh) {
  constexpr double kFlat = 1e-6;
  if (mesh.fixed == 0 || mesh.fixed >= mesh.nodes.size())
    return Error{.what = "no node, or each node, is fixed", .where = kWhere, .fix = "fix the nodes of one side"};
  if (!std::ranges::all_of(mesh.nodes, [](const Vector3d& node) { return node.allFinite(); }))
    return Error{.what = "a node's place is not a number", .where = kWhere, .fix = "correct it"};
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const auto& nodes = mesh.tetrahedra[t];
    const std::string name = "tetrahedron " + std::to_string(t);
    for (std::size_t i = 0; i < nodes_of(mesh.order); ++i)
      if (nodes[i] >= mesh.nodes.size())
        return Error{.what = name + " names a node that does not exist", .where = kWhere, .fix = "correct its nodes"};
    const double shape = shape_of(mesh, nodes);
    if (std::isnan(shape))
      return Error{.what = name + " has an edge without length", .where = kWhere, .fix = "move its corners apart"};
    if (shape < kFlat)
      return Error{.what = name + (shape < -kFlat ? " is turned inside out" : " is flat"),
                   .where = kWhere,
                   .fix = "swap two of its corners, or move them out of one plane"};
  }
  return {};
}

}  // namespace telepalp::tissue
