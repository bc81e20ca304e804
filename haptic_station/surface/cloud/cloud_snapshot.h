#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "haptic_station/surface/cloud/cloud_surface.h"
#include "haptic_station/surface/cloud/kdtree_index.h"

namespace telepalp::surface {

/// A cloud with normals that owns its points and index. Its geometry is static: a model, or one unorganised capture.
class CloudSnapshot final : public CloudSurface {
 public:
  /// A `shape.support_m` of 0 selects three times the cloud's spacing.
  CloudSnapshot(std::vector<CloudPoint> cloud, const CloudShape& shape, Index index);
  CloudSnapshot(const CloudSnapshot&) = delete;
  CloudSnapshot& operator=(const CloudSnapshot&) = delete;
  ~CloudSnapshot() = default;

  [[nodiscard]] const CloudShape& shape() const noexcept { return shape_; }
  [[nodiscard]] const std::vector<CloudPoint>& cloud() const noexcept { return storage_; }
  /// The spacing of the points [m] near `local`, a place relative to the origin. `evenly_m`: the spacing of all points
  /// if the shape is not graded; it is then returned.
  [[nodiscard]] double spacing_at_m(const Eigen::Vector3f& local, double evenly_m) const noexcept;

 private:
  std::vector<CloudPoint> storage_;
  std::shared_ptr<const NeighborIndex> owned_index_;
};

/// The positions of `points`, as an index takes them.
[[nodiscard]] IndexedPoints positions_of(const std::vector<CloudPoint>& points);

/// Mean spacing of a cloud: the median distance to the sixth neighbour, over a sample of the points, times √(π/6).
[[nodiscard]] double spacing_m(const std::vector<CloudPoint>& points, const NeighborIndex& index);

/// The unit normal of points that lie near each other, by principal component analysis; of either sign. nullopt when
/// they coincide or are collinear.
[[nodiscard]] std::optional<Eigen::Vector3f> normal_of(const std::vector<Eigen::Vector3f>& near);

/// Estimates a normal for each finite point by principal component analysis of its `neighbors` nearest points, oriented
/// towards `viewpoint`. Points whose neighbours coincide or are collinear are left out.
[[nodiscard]] std::vector<CloudPoint> with_normals(const std::vector<Eigen::Vector3f>& points, int neighbors,
                                                   const Eigen::Vector3f& viewpoint);

}  // namespace telepalp::surface
