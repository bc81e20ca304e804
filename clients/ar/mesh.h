#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace telepalp::ar {

/// A triangle mesh, in the depth camera's frame unless a function names another. It is only displayed: float suffices.
struct Mesh {
  struct Vertex {
    Eigen::Vector3f at;      ///< [m]
    Eigen::Vector3f normal;  ///< unit, outwards
    Eigen::Vector3f color;   ///< linear RGB, 0 to 1
  };
  std::vector<Vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Adds the triangles of `more` to `mesh`.
void append(Mesh& mesh, const Mesh& more);

/// The mesh after a rotation and a translation.
[[nodiscard]] Mesh moved(Mesh mesh, const Eigen::Matrix3f& rotation, const Eigen::Vector3f& translation);

/// The mesh with all vertices in one colour.
[[nodiscard]] Mesh painted(Mesh mesh, const Eigen::Vector3f& color);

/// Convert sRGB (0 to 255) to linear light (0 to 1) and back. Source: IEC 61966-2-1, approximated by the power 2.2.
[[nodiscard]] Eigen::Vector3f linear_from_srgb(int red, int green, int blue) noexcept;
[[nodiscard]] std::uint8_t srgb_from_linear(float value) noexcept;

}  // namespace telepalp::ar
