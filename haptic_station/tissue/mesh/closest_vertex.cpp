#include "haptic_station/tissue/mesh/closest_vertex.h"

#include <algorithm>
#include <limits>

namespace telepalp::tissue {

using Eigen::Vector3d;

std::uint32_t ClosestVertex::walk(const SurfaceMesh& mesh, std::uint32_t from, const Vector3d& point_m) noexcept {
  double least_m2 = (mesh.vertices()[from] - point_m).squaredNorm();
  for (bool nearer = true; nearer;) {
    nearer = false;
    for (const std::uint32_t v : mesh.ring(from))
      if (const double m2 = (mesh.vertices()[v] - point_m).squaredNorm(); m2 < least_m2) {
        least_m2 = m2;
        from = v;
        nearer = true;
      }
  }
  return from;
}

void ClosestVertex::search(const Vector3d& point_m) noexcept {
  ++searches_;
  searched_m_ = point_m;
  middle_ = tree_->nearest_vertex(point_m, [](std::uint32_t) { return true; });
  const auto ring = mesh_->ring(middle_);
  const std::uint32_t other = tree_->nearest_vertex(
      point_m, [&](std::uint32_t v) { return v != middle_ && std::ranges::find(ring, v) == ring.end(); });
  others_m_ = other < mesh_->vertices().size() ? (mesh_->vertices()[other] - point_m).norm()
                                               : std::numeric_limits<double>::infinity();
}

std::uint32_t ClosestVertex::at(const Vector3d& point_m) noexcept {
  std::uint32_t best = middle_;
  double least_m2 = (mesh_->vertices()[middle_] - point_m).squaredNorm();
  for (const std::uint32_t v : mesh_->ring(middle_))
    if (const double m2 = (mesh_->vertices()[v] - point_m).squaredNorm(); m2 < least_m2) least_m2 = m2, best = v;
  if (std::sqrt(least_m2) <= others_m_ - (point_m - searched_m_).norm()) return best;
  search(point_m);
  return middle_;
}

}  // namespace telepalp::tissue
