#include "haptic_station/tissue/mesh/surface_mesh.h"

namespace telepalp::tissue {

Eigen::Vector3d SurfaceMesh::normal(std::uint32_t triangle) const noexcept {
  const Triangle& corners = triangles_[triangle];
  const Eigen::Vector3d& a = vertices_[corners[0]];
  return (vertices_[corners[1]] - a).cross(vertices_[corners[2]] - a).normalized();
}

}  // namespace telepalp::tissue
