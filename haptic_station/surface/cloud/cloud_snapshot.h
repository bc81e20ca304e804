#pragma once

#include <memory>
#include <vector>

#include "haptic_station/surface/cloud/cloud_surface.h"
#include "haptic_station/surface/cloud/kdtree_index.h"

namespace telepalp::surface {

/// A cloud with normals that owns its points and index. Does not age: a model, or one unorganised capture.
class CloudSnapshot final : public CloudSurface {
 public:
  /// `support_m` of 0: three times the cloud's own spacing.
  CloudSnapshot(std::vector<CloudPoint> cloud, const CloudShape& shape, Index index);
  CloudSnapshot(const CloudSnapshot&) = delete;
  CloudSnapshot& operator=(const CloudSnapshot&) = delete;
  ~CloudSnapshot() = default;

  [[nodiscard]] const CloudShape& shape() const noexcept { return shape_; }
  [[nodiscard]] const std::vector<CloudPoint>& cloud() const noexcept { return storage_; }

 private:
  std::vector<CloudPoint> storage_;
  std::shared_ptr<const NeighborIndex> owned_index_;
};

/// Median distance to the sixth neighbour over √6, of up to 500 points: the side of the cell that a point has to
/// itself.
[[nodiscard]] double spacing_m(const std::vector<CloudPoint>& points, const NeighborIndex& index);

/// A normal for each finite point from its `neighbors` nearest by principal components, towards `viewpoint`; points in
/// one place or on a line are left out.
[[nodiscard]] std::vector<CloudPoint> with_normals(const std::vector<Eigen::Vector3f>& points, int neighbors,
                                                   const Eigen::Vector3f& viewpoint);

}  // namespace telepalp::surface
