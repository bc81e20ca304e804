#pragma once

#include <cmath>
#include <vector>

#include "haptic_station/tissue/mesh/surface_mesh.h"

namespace telepalp::tissue {

/// A disc of 0.05 m with edges of 4 mm, whose heights are `height(x, z)`.
template <class Height>
SurfaceMesh bent_disc(const Height& height) {
  const SurfaceMesh flat = lattice_disc(0.05, 0.004);
  std::vector<Eigen::Vector3d> vertices(flat.vertices().begin(), flat.vertices().end());
  for (Eigen::Vector3d& v : vertices) v.y() = height(v.x(), v.z());
  return *make_mesh(vertices, {flat.triangles().begin(), flat.triangles().end()});
}

/// Grooves that are deeper than wide: concave, as in the appendix of paper S4 (docs/sources.md).
inline SurfaceMesh groove() {
  return bent_disc([](double x, double) { return 0.03 * std::cos(x / 0.004); });
}

inline std::uint32_t brute_force_vertex(const SurfaceMesh& mesh, const Eigen::Vector3d& point_m) {
  std::uint32_t best = 0;
  for (std::uint32_t v = 1; v < mesh.vertices().size(); ++v)
    if ((mesh.vertices()[v] - point_m).squaredNorm() < (mesh.vertices()[best] - point_m).squaredNorm()) best = v;
  return best;
}

}  // namespace telepalp::tissue
