#pragma once

#include "haptic_station/tissue/mesh/triangle_tree.h"

namespace telepalp::tissue {

/// The vertex of a mesh that is nearest to a moving point.
///
/// Paper S4 (docs/sources.md), section 5, walks from the last closest vertex to a nearer neighbour until there is none.
/// S4's appendix shows a concave mesh on which this walk ends too early. Here a walk's answer counts only if it is
/// proven: an exact search also yields the distance of the nearest vertex that is not a neighbour. While the point has
/// moved so little that this vertex cannot be nearer than the best neighbour, the walk is right. Else the tree is
/// searched. Owner: haptic thread.
class ClosestVertex {
 public:
  ClosestVertex(const SurfaceMesh& mesh, const TriangleTree& tree) noexcept : mesh_(&mesh), tree_(&tree) {}

  /// Exact. Of equally near vertices, any.
  [[nodiscard]] std::uint32_t at(const Eigen::Vector3d& point_m) noexcept;
  /// S4's walk alone, from `from`. May be wrong on a concave mesh and after a long way.
  [[nodiscard]] static std::uint32_t walk(const SurfaceMesh& mesh, std::uint32_t from,
                                          const Eigen::Vector3d& point_m) noexcept;
  /// How often at() searched the tree.
  [[nodiscard]] std::uint64_t searches() const noexcept { return searches_; }

 private:
  void search(const Eigen::Vector3d& point_m) noexcept;

  const SurfaceMesh* mesh_;
  const TriangleTree* tree_;
  std::uint32_t middle_ = 0;                              ///< the closest vertex at the last search
  Eigen::Vector3d searched_m_ = Eigen::Vector3d::Zero();  ///< the point of the last search
  double others_m_ = -1.0;  ///< distance, at the last search, of the nearest vertex outside the ring of middle_
  std::uint64_t searches_ = 0;
};

}  // namespace telepalp::tissue
