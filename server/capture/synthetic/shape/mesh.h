#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "support/models/point_model.h"

namespace telepalp::server {

/// Triangles over shared vertices [m]: y towards the patient's head, +z out of the patient's front.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// The triangles of a model. An error when there are none, or a vertex is not finite; `name` stands for the file.
[[nodiscard]] Result<TriangleMesh> mesh_of(models::PointModel model, const std::string& name);

/// The same from a PLY or OBJ file.
[[nodiscard]] Result<TriangleMesh> read_mesh(const std::filesystem::path& file);

/// One unit normal for each vertex, the mean of its triangles' weighted by area; zero for a vertex without triangles.
[[nodiscard]] std::vector<Eigen::Vector3f> vertex_normals(const TriangleMesh& mesh);

}  // namespace telepalp::server
