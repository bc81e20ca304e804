#include "haptic_station/surface/cloud/cloud_snapshot.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "proto/words/numbers/quantile.h"

namespace telepalp::surface {
IndexedPoints positions_of(const std::vector<CloudPoint>& points) {
  IndexedPoints out;
  out.at_m.reserve(points.size());
  for (const CloudPoint& point : points) out.at_m.push_back(point.at_m);
  return out;
}

double spacing_m(const std::vector<CloudPoint>& points, const NeighborIndex& index) {
  std::vector<float> squared;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / 500);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    std::array<Neighbor, 7> found;  // the point itself and six neighbours
    const std::size_t count = index.within(points[i].at_m, kAnywhere_m, found);
    float farthest = 0.0F;
    for (std::size_t k = 0; k < count; ++k) farthest = std::max(farthest, found[k].squared_m2);
    if (count == found.size()) squared.push_back(farthest);
  }
  if (squared.empty()) return 0.0;
  return std::sqrt(double{median_of(squared)} / 6.0) * std::sqrt(3.14159265);
}

CloudSnapshot::CloudSnapshot(std::vector<CloudPoint> cloud, const CloudShape& shape, Index index)
    : storage_(std::move(cloud)), owned_index_(make_index(index, positions_of(storage_))) {
  shape_ = shape;
  if (!(shape_.support_m > 0.0))
    shape_.support_m = kSupportPerSpacing * std::max(1e-6, spacing_m(storage_, *owned_index_));
  points_ = storage_;
  index_ = owned_index_.get();
  points = static_cast<std::uint32_t>(storage_.size());
  index_name = index_->name();
  motion.ages = false;
}

double CloudSnapshot::spacing_at_m(const Eigen::Vector3f& local, double evenly_m) const noexcept {
  if (!shape_.graded) return evenly_m;
  const std::optional<Neighbor> near = nearest(local, static_cast<double>(kAnywhere_m));
  return near ? static_cast<double>(storage_[near->index].support_m) / kSupportPerSpacing : evenly_m;
}

std::optional<Eigen::Vector3f> normal_of(const std::vector<Eigen::Vector3f>& near) {
  if (near.empty()) return std::nullopt;
  const auto count = static_cast<double>(near.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3f& at : near) {
    const Eigen::Vector3d from = (at - near.front()).cast<double>();
    mean += from / count;
    square += from * from.transpose() / count;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(square - mean * mean.transpose());
  if (!(solver.eigenvalues()[1] > 1e-4 * solver.eigenvalues()[2])) return std::nullopt;
  return solver.eigenvectors().col(0).cast<float>().normalized();
}

std::vector<CloudPoint> with_normals(const std::vector<Eigen::Vector3f>& points, int neighbors,
                                     const Eigen::Vector3f& viewpoint) {
  const auto index = make_nanoflann_index({.at_m = points, .width = 0});
  std::vector<Neighbor> found(static_cast<std::size_t>(std::clamp(neighbors, 3, 256)));
  std::vector<Eigen::Vector3f> near;
  std::vector<CloudPoint> out;
  for (const Eigen::Vector3f& at : points) {
    if (!at.allFinite()) continue;
    const std::size_t count = index->within(at, kAnywhere_m, found);
    near.clear();
    for (std::size_t i = 0; i < count; ++i) near.push_back(points[found[i].index]);
    const std::optional<Eigen::Vector3f> normal = normal_of(near);
    if (normal) out.push_back({at, normal->dot(viewpoint - at) < 0.0F ? Eigen::Vector3f(-*normal) : *normal});
  }
  return out;
}

}  // namespace telepalp::surface
