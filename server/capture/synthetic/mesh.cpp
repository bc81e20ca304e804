#include "server/capture/synthetic/mesh.h"

#include <Eigen/Geometry>

namespace telepalp::server {

std::vector<Eigen::Vector3f> vertex_normals(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3f> normals(mesh.vertices.size(), Eigen::Vector3f::Zero());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f twice_area_normal =
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    for (const std::uint32_t corner : {a, b, c}) normals[corner] += twice_area_normal;
  }
  for (Eigen::Vector3f& normal : normals) {
    const float length = normal.norm();
    normal = length > 0.0F ? Eigen::Vector3f{normal / length} : Eigen::Vector3f::Zero();
  }
  return normals;
}

}  // namespace telepalp::server
