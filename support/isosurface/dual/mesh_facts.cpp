#include "support/isosurface/mesh_facts.h"

#include <algorithm>
#include <numeric>

#include "support/isosurface/cells/key_map.h"

namespace telepalp::isosurface {
namespace {

using Eigen::Vector3d;

bool is_sliver(const std::array<Vector3d, 3>& p) {
  constexpr double kLeastHeight = 1e-3;
  const double longest = std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
  return (p[1] - p[0]).cross(p[2] - p[0]).norm() <= kLeastHeight * longest * longest;
}

std::uint32_t root(std::vector<std::uint32_t>& above, std::uint32_t point) {
  while (above[point] != point) point = above[point] = above[above[point]];
  return point;
}

}  // namespace

MeshFacts facts_of(const Mesh& mesh) {
  MeshFacts facts;
  KeyMap<int> balance;  // of an edge: uses forwards minus backwards, plus 1024 times all uses
  std::vector<std::uint64_t> edges;
  std::vector<std::uint32_t> above(mesh.points.size());
  std::iota(above.begin(), above.end(), 0U);
  std::vector<bool> used(mesh.points.size(), false);
  for (const auto& t : mesh.triangles) {
    const std::array p{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    facts.volume_m3 += p[0].dot(p[1].cross(p[2])) / 6.0;
    facts.slivers += is_sliver(p) ? 1 : 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = t[i], b = t[(i + 1) % 3];
      const auto [found, added] = balance.insert(std::min(a, b) << 32 | std::max(a, b));
      *found += 1024 + (a < b ? 1 : -1);
      if (added) edges.push_back(std::min(a, b) << 32 | std::max(a, b));
      used[a] = true;
      above[root(above, t[i])] = root(above, t[(i + 1) % 3]);
    }
  }
  for (const std::uint64_t edge : edges) facts.open_edges += *balance.find(edge) == 2048 ? 0 : 1;
  const auto points = std::ranges::count(used, true);
  for (std::uint32_t i = 0; i < above.size(); ++i) facts.parts += used[i] && above[i] == i ? 1 : 0;
  facts.euler = static_cast<long>(points) - static_cast<long>(edges.size()) + static_cast<long>(mesh.triangles.size());
  return facts;
}

}  // namespace telepalp::isosurface
