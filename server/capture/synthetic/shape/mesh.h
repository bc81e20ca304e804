#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "support/models/point_model.h"

namespace telepalp::capture {

/// Triangles over shared vertices [m]: y towards the patient's head, +z out of the patient's front.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// The triangles of a model. `name`: the file's name, for errors. Error: no triangles, or a vertex that is not finite.
[[nodiscard]] Result<TriangleMesh> mesh_of(models::PointModel model, const std::string& name);

/// Reads a triangle mesh from a PLY or OBJ file.
[[nodiscard]] Result<TriangleMesh> read_mesh(const std::filesystem::path& file);

/// One unit normal per vertex: the area-weighted mean of its triangles' normals; zero for a vertex without triangles.
[[nodiscard]] std::vector<Eigen::Vector3f> vertex_normals(const TriangleMesh& mesh);

}  // namespace telepalp::capture
