#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::tissue {

using Triangle = std::array<std::uint32_t, 3>;

/// A triangle mesh whose neighbours are found in constant time, as paper S4 (docs/sources.md), section 5, needs it.
/// Immutable. Made by make_mesh().
class SurfaceMesh {
 public:
  [[nodiscard]] std::span<const Eigen::Vector3d> vertices() const noexcept { return vertices_; }  ///< [m]
  [[nodiscard]] std::span<const Triangle> triangles() const noexcept { return triangles_; }
  /// The vertices that share an edge with `vertex`.
  [[nodiscard]] std::span<const std::uint32_t> ring(std::uint32_t vertex) const noexcept {
    return {ring_.data() + ring_from_[vertex], ring_from_[vertex + 1] - ring_from_[vertex]};
  }
  /// True on the edge of the mesh, which includes the edge of a hole.
  [[nodiscard]] bool on_rim(std::uint32_t vertex) const noexcept { return on_rim_[vertex] != 0; }
  /// Unit vector, counter-clockwise corners seen from its head.
  [[nodiscard]] Eigen::Vector3d normal(std::uint32_t triangle) const noexcept;

 private:
  friend Result<SurfaceMesh> make_mesh(std::vector<Eigen::Vector3d> vertices, std::vector<Triangle> triangles);

  void link();

  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> ring_, ring_from_;
  std::vector<std::uint8_t> on_rim_;
};

/// Error: a coordinate is not finite, a corner does not exist, a triangle has no area, an edge has more than two
/// triangles, or two triangles pass the same edge in the same direction.
[[nodiscard]] Result<SurfaceMesh> make_mesh(std::vector<Eigen::Vector3d> vertices, std::vector<Triangle> triangles);

/// A level disc of equilateral triangles with normals along +y, about the origin, which is the middle of a triangle.
/// `radius_m` >= 2 edges.
[[nodiscard]] SurfaceMesh lattice_disc(double radius_m, double edge_m);

}  // namespace telepalp::tissue
