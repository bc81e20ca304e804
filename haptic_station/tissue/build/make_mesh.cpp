#include "haptic_station/tissue/mesh/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "proto/words/demand.h"

namespace telepalp::tissue {
namespace {

Error refuse(std::size_t triangle, const std::string& what, const std::string& fix) {
  return {.what = "triangle " + std::to_string(triangle) + " " + what, .where = "tissue mesh", .fix = fix};
}

bool all_finite(const std::vector<Eigen::Vector3d>& vertices) {
  return std::ranges::all_of(vertices, [](const Eigen::Vector3d& vertex) { return vertex.allFinite(); });
}

}  // namespace

void SurfaceMesh::link() {
  std::vector<std::set<std::uint32_t>> ring(vertices_.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const Triangle& triangle : triangles_)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i];
      const std::uint32_t to = triangle[(i + 1) % 3];
      ring[from].insert(to);
      ring[to].insert(from);
      ++uses[std::minmax(from, to)];
    }
  on_rim_.assign(vertices_.size(), 0);
  for (const auto& [edge, count] : uses)
    if (count == 1) on_rim_[edge.first] = on_rim_[edge.second] = 1;
  ring_from_ = {0};
  for (const std::set<std::uint32_t>& neighbours : ring) {
    ring_.insert(ring_.end(), neighbours.begin(), neighbours.end());
    ring_from_.push_back(static_cast<std::uint32_t>(ring_.size()));
  }
}

Result<SurfaceMesh> make_mesh(std::vector<Eigen::Vector3d> vertices, std::vector<Triangle> triangles) {
  if (triangles.empty())
    return Error{.what = "the mesh has no triangle", .where = "tissue mesh", .fix = "give at least one triangle"};
  if (!all_finite(vertices))
    return Error{.what = "a coordinate is not a finite number", .where = "tissue mesh", .fix = "give lengths in m"};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> passed;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const std::uint32_t corner : triangles[t])
      if (corner >= vertices.size())
        return refuse(t, "has the corner " + std::to_string(corner) + ", which does not exist",
                      "the mesh has " + std::to_string(vertices.size()) + " vertices; count from 0");
    const Eigen::Vector3d& a = vertices[triangles[t][0]];
    if (!((vertices[triangles[t][1]] - a).cross(vertices[triangles[t][2]] - a).norm() > 1e-14))
      return refuse(t, "has no area", "leave it out, or give it three corners that are not on one line");
    for (int i = 0; i < 3; ++i)
      if (const auto [other, fresh] = passed.try_emplace({triangles[t][i], triangles[t][(i + 1) % 3]}, t); !fresh)
        return refuse(t, "and triangle " + std::to_string(other->second) + " pass the same edge in the same direction",
                      "let at most two triangles share an edge, with corners in the same turning sense");
  }
  SurfaceMesh mesh;
  mesh.vertices_ = std::move(vertices);
  mesh.triangles_ = std::move(triangles);
  mesh.link();
  return mesh;
}

SurfaceMesh lattice_disc(double radius_m, double edge_m) {
  std::vector<Eigen::Vector3d> vertices;
  std::map<std::pair<int, int>, std::uint32_t> index;
  const double row_m = edge_m * std::sqrt(0.75);
  const auto place = [&](int i, int j) {
    return Eigen::Vector3d(edge_m * (i + 0.5 * j - 0.5), 0.0, row_m * (j - 1.0 / 3));
  };
  const auto vertex = [&](int i, int j) {
    const auto [at, fresh] = index.try_emplace({i, j}, static_cast<std::uint32_t>(vertices.size()));
    if (fresh) vertices.push_back(place(i, j));
    return at->second;
  };
  std::vector<Triangle> triangles;
  const int most = 2 + static_cast<int>(2.0 * radius_m / edge_m);
  const auto add = [&](std::array<std::pair<int, int>, 3> corners) {
    for (const auto& [i, j] : corners)
      if (place(i, j).norm() > radius_m) return;
    Triangle triangle{};
    for (int k = 0; k < 3; ++k) triangle[k] = vertex(corners[k].first, corners[k].second);
    triangles.push_back(triangle);
  };
  for (int j = -most; j <= most; ++j)
    for (int i = -most; i <= most; ++i) {
      add({{{i, j}, {i, j + 1}, {i + 1, j}}});
      add({{{i + 1, j}, {i, j + 1}, {i + 1, j + 1}}});
    }
  Result<SurfaceMesh> mesh = make_mesh(std::move(vertices), std::move(triangles));
  demand(mesh.ok(), "a lattice of equilateral triangles is a mesh");
  return std::move(*mesh);
}

}  // namespace telepalp::tissue
