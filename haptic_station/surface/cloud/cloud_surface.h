#pragma once

#include <optional>
#include <span>

#include "haptic_station/surface/cloud/neighbor_index.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// A point with a normal, relative to the cloud's origin.
struct CloudPoint {
  Eigen::Vector3f at_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit, out of the body
  float support_m = 0.0F;  ///< with CloudShape::graded: a query farther away than this gives the point no weight
};

struct CloudShape {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< origin of CloudPoint::at_m, in the snapshot's frame
  double support_m = 0.02;                             ///< a point farther than this from the query has no weight
  std::size_t neighbors = 0;   ///< k > 0: the distance of the k-th neighbour replaces a greater support; 0: k is 256
  double seed_radius_m = 0.3;  ///< search radius for the nearest point
  /// Each point has its own support, of at most support_m; kSupportGrade bounds how fast it changes over the surface.
  bool graded = false;
};

/// The support where the settings give none, in spacings of the points.
inline constexpr double kSupportPerSpacing = 3.0;
/// Greatest difference between the supports of two points, divided by the distance between them.
inline constexpr double kSupportGrade = 0.5;

/// A point-set surface for unorganised clouds: a weighted mean of tangent planes. Each weight falls to zero at the
/// support, a distance in metres. The weight of a point also fades to zero as its normal turns away from `facing`, the
/// outward direction given to evaluate(): such a point belongs to the other side of a thin sheet. If the support is the
/// distance of the k-th neighbour, the implicit function is continuous, but its gradient neglects the change of that
/// distance. Does not own points or index.
class CloudSurface : public SurfaceSnapshot {
 public:
  [[nodiscard]] FieldSample evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d& facing,
                                     const MotionBasis& basis) const noexcept final;
  [[nodiscard]] std::optional<Seed> seed(const Eigen::Vector3d& query) const noexcept final;
  [[nodiscard]] double stride_m(const Eigen::Vector3d& query) const noexcept final;
  [[nodiscard]] bool realtime_safe() const noexcept final { return index_ != nullptr && index_->realtime_safe(); }

 protected:
  ~CloudSurface() = default;
  /// The point that is nearest to `local` (relative to the origin), if it lies within `within_m`.
  [[nodiscard]] std::optional<Neighbor> nearest(const Eigen::Vector3f& local, double within_m) const noexcept;
  /// The distance from `local` within which all points with a weight lie [m].
  [[nodiscard]] double reach_m(const Eigen::Vector3f& local) const noexcept;
  CloudShape shape_;
  std::span<const CloudPoint> points_;
  const NeighborIndex* index_ = nullptr;
};

}  // namespace telepalp::surface
