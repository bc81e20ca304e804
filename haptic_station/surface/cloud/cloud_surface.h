#pragma once

#include <span>

#include "haptic_station/surface/cloud/neighbor_index.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// A point with a normal, relative to the cloud's origin.
struct CloudPoint {
  Eigen::Vector3f at_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit, out of the body
};

struct CloudShape {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
  double support_m = 0.02;     ///< radius of the weights; the farthest that counts where `neighbors` is set
  std::size_t neighbors = 0;   ///< 0: fixed support; else the support ends at this neighbour's distance
  double seed_radius_m = 0.3;  ///< how far the nearest point is looked for
};

/// The point-set surface with a metric support: for clouds without a lattice. The same mean of tangent planes as
/// GridSurface. Points whose normal turns away from `facing` belong to the other side of a sheet and are left out,
/// fading. With a k-th neighbour support f is continuous but its gradient neglects the support's own change. Borrows
/// points and index.
class CloudSurface : public SurfaceSnapshot {
 public:
  [[nodiscard]] FieldSample evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d& facing,
                                     const MotionBasis& basis) const noexcept final;
  [[nodiscard]] std::optional<Seed> seed(const Eigen::Vector3d& query) const noexcept final;
  [[nodiscard]] double stride_m(const Eigen::Vector3d& query) const noexcept final;
  [[nodiscard]] bool realtime_safe() const noexcept final { return index_ != nullptr && index_->realtime_safe(); }

 protected:
  ~CloudSurface() = default;
  CloudShape shape_;
  std::span<const CloudPoint> points_;
  const NeighborIndex* index_ = nullptr;
};

}  // namespace telepalp::surface
