#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::server {

/// Triangles over shared vertices [m]: y towards the patient's head, +z out of the patient's front.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// The mesh that the PLY file in `bytes` holds: ascii or binary_little_endian, x y z of type float or double, faces of
/// three or more corners (a polygon becomes a fan). Other properties are skipped. `name` stands for the file in errors.
/// Sizes are checked against the bytes that are there before anything is allocated; a vertex that is not finite and a
/// face that names no vertex are errors.
[[nodiscard]] Result<TriangleMesh> parse_ply(std::span<const std::byte> bytes, const std::string& name);

/// The same from a file of at most 256 MiB.
[[nodiscard]] Result<TriangleMesh> read_ply(const std::filesystem::path& file);

/// One unit normal for each vertex, the mean of its triangles' weighted by area; zero for a vertex without triangles.
[[nodiscard]] std::vector<Eigen::Vector3f> vertex_normals(const TriangleMesh& mesh);

}  // namespace telepalp::server
