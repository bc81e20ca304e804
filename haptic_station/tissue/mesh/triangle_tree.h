#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "haptic_station/tissue/mesh/surface_mesh.h"

namespace telepalp::tissue {

/// A point of a mesh.
struct MeshPoint {
  std::uint32_t triangle = 0;
  Eigen::Vector3d shares = Eigen::Vector3d::Zero();  ///< barycentric coordinates
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();
};

/// Boxes around the triangles of a mesh, in a tree: exact answers at any distance and speed. Queries neither allocate
/// nor throw. The mesh must outlive the tree.
class TriangleTree {
 public:
  explicit TriangleTree(const SurfaceMesh& mesh);

  [[nodiscard]] MeshPoint nearest(const Eigen::Vector3d& to_m) const noexcept;
  /// The first point of the mesh on the way between two points; nullopt: the way is free.
  [[nodiscard]] std::optional<MeshPoint> first_hit(const Eigen::Vector3d& from_m,
                                                   const Eigen::Vector3d& to_m) const noexcept;
  /// The vertex nearest to `to_m`; of equally near ones, the one with the least index.
  /// Considers only vertices v with outside(v). Returns the number of vertices of the mesh if there is no such vertex.
  template <class Outside>
  [[nodiscard]] std::uint32_t nearest_vertex(const Eigen::Vector3d& to_m, const Outside& outside) const noexcept {
    std::uint32_t best = static_cast<std::uint32_t>(mesh_->vertices().size());
    double least_m2 = std::numeric_limits<double>::infinity();
    search(to_m, least_m2, [&](std::uint32_t triangle) {
      for (const std::uint32_t v : mesh_->triangles()[triangle]) {
        const double d2 = (mesh_->vertices()[v] - to_m).squaredNorm();
        if ((d2 < least_m2 || (d2 == least_m2 && v < best)) && outside(v)) least_m2 = d2, best = v;
      }
    });
    return best;
  }

 private:
  static constexpr int kLeaf = 4;
  struct Node {
    Eigen::AlignedBox3d box;
    std::uint32_t first = 0;  ///< of a leaf: index into order_; else: index of the right child (the left one is next)
    std::uint32_t count = 0;  ///< of a leaf: number of triangles; 0: not a leaf
  };
  void build(std::uint32_t first, std::uint32_t count);

  /// Visits the triangles of all leaves whose boxes are not farther than `least_m2`, which the visitor lowers.
  template <class Visit>
  void search(const Eigen::Vector3d& to_m, const double& least_m2, const Visit& visit) const noexcept {
    std::uint32_t stack[64];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const std::uint32_t at = stack[--depth];
      const Node& node = nodes_[at];
      if (node.box.squaredExteriorDistance(to_m) > least_m2) continue;
      if (node.count > 0) {
        for (std::uint32_t i = 0; i < node.count; ++i) visit(order_[node.first + i]);
        continue;
      }
      std::uint32_t near = at + 1;
      std::uint32_t far = node.first;
      if (nodes_[far].box.squaredExteriorDistance(to_m) < nodes_[near].box.squaredExteriorDistance(to_m))
        std::swap(near, far);
      stack[depth++] = far;
      stack[depth++] = near;
    }
  }

  const SurfaceMesh* mesh_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace telepalp::tissue
