#include <algorithm>

#include "haptic_station/tissue/mesh/triangle_tree.h"

namespace telepalp::tissue {

TriangleTree::TriangleTree(const SurfaceMesh& mesh) : mesh_(&mesh), order_(mesh.triangles().size()) {
  for (std::uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
  build(0, static_cast<std::uint32_t>(order_.size()));
}

void TriangleTree::build(std::uint32_t first, std::uint32_t count) {
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  Eigen::AlignedBox3d box;
  for (std::uint32_t i = first; i < first + count; ++i)
    for (const std::uint32_t v : mesh_->triangles()[order_[i]]) box.extend(mesh_->vertices()[v]);
  nodes_[at].box = box;
  if (count <= kLeaf) {
    nodes_[at].first = first;
    nodes_[at].count = count;
    return;
  }
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto middle_of = [&](std::uint32_t triangle) {
    double sum = 0.0;
    for (const std::uint32_t v : mesh_->triangles()[triangle]) sum += mesh_->vertices()[v][axis];
    return sum;
  };
  const std::uint32_t half = count / 2;
  std::nth_element(order_.begin() + first, order_.begin() + first + half, order_.begin() + first + count,
                   [&](std::uint32_t a, std::uint32_t b) { return middle_of(a) < middle_of(b); });
  build(first, half);
  nodes_[at].first = static_cast<std::uint32_t>(nodes_.size());
  build(first + half, count - half);
}

}  // namespace telepalp::tissue
