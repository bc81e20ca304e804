#include "haptic_station/solids/solid_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unordered_map>

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

// The corners of a cube are numbered by their bits: x 1, y 2, z 4. The six tetrahedra share the diagonal from 0 to 7,
// and cut each face along the same diagonal as the cube beyond it.
constexpr int kTetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};

struct Lattice {
  Vector3d origin;
  double cell_m;
  Vector3i cells;

  [[nodiscard]] std::uint64_t index(const Vector3i& node) const noexcept {
    const auto x = static_cast<std::uint64_t>(node.x());
    const auto y = static_cast<std::uint64_t>(node.y());
    const auto z = static_cast<std::uint64_t>(node.z());
    const auto nx = static_cast<std::uint64_t>(cells.x() + 1);
    const auto ny = static_cast<std::uint64_t>(cells.y() + 1);
    return (z * ny + y) * nx + x;
  }
  [[nodiscard]] Vector3d at(const Vector3i& node) const noexcept { return origin + cell_m * node.cast<double>(); }
};

class Marcher {
 public:
  Marcher(const SolidTree& tree, const Lattice& lattice) : tree_(tree), lattice_(lattice) {}

  SolidMesh march() {
    block(Vector3i::Zero(), lattice_.cells);
    return std::move(mesh_);
  }

 private:
  /// Skips a block of cells that the surface cannot reach, and halves any other block down to single cells.
  void block(const Vector3i& low, const Vector3i& high) {
    const Vector3i size = high - low;
    const Vector3d middle = lattice_.origin + 0.5 * lattice_.cell_m * (low + high).cast<double>();
    const double reach_m = 0.5 * lattice_.cell_m * size.cast<double>().norm();
    if (std::abs(solid_at(tree_, middle).m) > tree_.steepest * reach_m) return;
    int axis = 0;
    const int longest = size.maxCoeff(&axis);
    if (longest <= 1) return cube(low);
    Vector3i cut = high;
    cut[axis] = low[axis] + longest / 2;
    block(low, cut);
    cut = low;
    cut[axis] = low[axis] + longest / 2;
    block(cut, high);
  }

  double value(const Vector3i& node) {
    const auto [found, added] = values_.try_emplace(lattice_.index(node), 0.0);
    if (added) found->second = solid_at(tree_, lattice_.at(node)).m;
    return found->second;
  }

  void cube(const Vector3i& low) {
    for (const auto& corners : kTetrahedra) {
      std::array<Corner, 4> tetrahedron;
      for (std::size_t i = 0; i < 4; ++i) {
        const int c = corners[i];
        const Vector3i node = low + Vector3i(c & 1, (c >> 1) & 1, (c >> 2) & 1);
        tetrahedron[i] = {node, value(node)};
      }
      cut(tetrahedron);
    }
  }

  struct Corner {
    Vector3i node;
    double m;
  };

  /// The triangles of a tetrahedron, whose corners are right-handed. Corners are swapped so that those inside come
  /// first. An even number of swaps keeps them right-handed.
  void cut(std::array<Corner, 4> t) {
    const auto inside = [](const Corner& corner) { return corner.m < 0.0; };
    int swaps = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (inside(t[i])) {
        if (i != count) ++swaps;
        std::swap(t[i], t[count++]);
      }
    if (count == 0 || count == 4) return;
    const bool mirrored = swaps % 2 == 1;
    if (count == 1) add(point(t[0], t[1]), point(t[0], t[2]), point(t[0], t[3]), mirrored);
    if (count == 3) add(point(t[3], t[0]), point(t[3], t[1]), point(t[3], t[2]), mirrored);
    if (count == 2) {
      const std::uint32_t a = point(t[0], t[2]);
      const std::uint32_t b = point(t[0], t[3]);
      const std::uint32_t c = point(t[1], t[3]);
      const std::uint32_t d = point(t[1], t[2]);
      add(a, b, c, mirrored);
      add(a, c, d, mirrored);
    }
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool mirrored) {
    mesh_.triangles.push_back(mirrored ? std::array{a, c, b} : std::array{a, b, c});
  }

  /// The point of the surface on an edge, once for all tetrahedra that share the edge.
  std::uint32_t point(const Corner& one, const Corner& other) {
    const Vector3i low = one.node.cwiseMin(other.node);
    const Vector3i along = one.node.cwiseMax(other.node) - low;  // all edges of the tetrahedra go upwards
    const auto direction = static_cast<std::uint64_t>(along.x() + 2 * along.y() + 4 * along.z());
    const auto [found, added] = points_.try_emplace(lattice_.index(low) * 8 + direction, 0U);
    if (added) {
      found->second = static_cast<std::uint32_t>(mesh_.points.size());
      const double share = one.m / (one.m - other.m);
      mesh_.points.push_back(lattice_.at(one.node) + share * (lattice_.at(other.node) - lattice_.at(one.node)));
    }
    return found->second;
  }

  const SolidTree& tree_;
  const Lattice& lattice_;
  SolidMesh mesh_;
  std::unordered_map<std::uint64_t, double> values_;
  std::unordered_map<std::uint64_t, std::uint32_t> points_;
};

}  // namespace

Result<SolidMesh> mesh_of(const SolidTree& tree, double cell_m) {
  const Box& box = tree.box();
  if (!box.bounded())
    return Error{
        .what = "the solid extends without end", .where = "mesh", .fix = "clip it, or intersect it with a box"};
  // One cell more on each side, so that the surface closes inside the lattice.
  const Vector3d cells = ((box.high - box.low) / cell_m).array().ceil() + 2.0;
  if (!(cells.prod() <= static_cast<double>(kMostCells)))
    return Error{.what = "the mesh would need more than 64 million cells",
                 .where = "mesh",
                 .fix = "give larger cells (--cell-mm)"};
  const Lattice lattice{box.low - Vector3d::Constant(cell_m), cell_m, cells.cast<int>()};
  return Marcher(tree, lattice).march();
}

std::size_t open_edges(const SolidMesh& mesh) {
  std::unordered_map<std::uint64_t, int> balance;  // per edge: uses forwards minus backwards, plus 1024 times all uses
  for (const auto& triangle : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = triangle[i];
      const std::uint64_t b = triangle[(i + 1) % 3];
      balance[std::min(a, b) << 32 | std::max(a, b)] += 1024 + (a < b ? 1 : -1);
    }
  return static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 2048; }));
}

std::string to_ply(const SolidMesh& mesh) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.points.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(mesh.triangles.size()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
  std::array<char, 96> line{};
  for (const Vector3d& p : mesh.points) {
    std::snprintf(line.data(), line.size(), "%.7g %.7g %.7g\n", p.x(), p.y(), p.z());
    text += line.data();
  }
  for (const auto& t : mesh.triangles) {
    std::snprintf(line.data(), line.size(), "3 %u %u %u\n", t[0], t[1], t[2]);
    text += line.data();
  }
  return text;
}

std::string to_obj(const SolidMesh& mesh) {
  std::string text;
  std::array<char, 96> line{};
  for (const Vector3d& p : mesh.points) {
    std::snprintf(line.data(), line.size(), "v %.7g %.7g %.7g\n", p.x(), p.y(), p.z());
    text += line.data();
  }
  for (const auto& t : mesh.triangles) {
    std::snprintf(line.data(), line.size(), "f %u %u %u\n", t[0] + 1, t[1] + 1, t[2] + 1);
    text += line.data();
  }
  return text;
}

}  // namespace telepalp::solids
