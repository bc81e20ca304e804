#include "server/capture/synthetic/shape/mesh.h"

#include <Eigen/Geometry>
#include <utility>

namespace telepalp::capture {

Result<TriangleMesh> mesh_of(models::PointModel model, const std::string& name) {
  constexpr const char* kFix = "give a mesh of triangles, as PLY or OBJ";
  for (std::size_t i = 0; i < model.points.size(); ++i)
    if (!model.points[i].allFinite())
      return Error{.what = "vertex " + std::to_string(i) + " has a coordinate that is not a finite number",
                   .where = name,
                   .fix = "correct this vertex (the first is vertex 0), or export the mesh again"};
  if (model.triangles.empty()) return Error{.what = "has no triangles", .where = name, .fix = kFix};
  return TriangleMesh{std::move(model.points), std::move(model.triangles)};
}

Result<TriangleMesh> read_mesh(const std::filesystem::path& file) {
  Result<models::PointModel> model = models::read_point_model(file);
  if (!model) return model.error();
  return mesh_of(std::move(model).value(), file.string());
}

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

}  // namespace telepalp::capture
