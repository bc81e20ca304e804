#pragma once

#include <memory>
#include <optional>

#include "haptic_station/surface/cloud/kdtree_index.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// S1 §II.C to the letter, the slow reference that everything else is measured against: up to N points within R of the
/// query; a normal for each from its own search with the same N and R, by principal components, towards the camera;
/// Adamson and Alexa's implicit function f = n̄·(x − ā) over weighted means, with Wyvill's soft-object weights of
/// influence radius R. The normal stands for the gradient, as there. Error: f jumps whenever the N-th neighbour
/// changes, since its weight is far from zero there (telepalp-bench surface). Allocates in its searches:
/// realtime_safe() is false.
class PaperSurface final : public SurfaceSnapshot {
 public:
  PaperSurface(IndexedPoints cloud, const SurfaceSettings& settings);
  PaperSurface(const PaperSurface&) = delete;
  PaperSurface& operator=(const PaperSurface&) = delete;
  ~PaperSurface() = default;

  [[nodiscard]] FieldSample evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d& facing,
                                     const MotionBasis& basis) const noexcept override;
  [[nodiscard]] std::optional<Seed> seed(const Eigen::Vector3d& query) const noexcept override;
  [[nodiscard]] double stride_m(const Eigen::Vector3d& query) const noexcept override;
  [[nodiscard]] bool realtime_safe() const noexcept override { return false; }

 private:
  [[nodiscard]] std::size_t neighbors_of(const Eigen::Vector3f& query, std::span<Neighbor> found) const noexcept;
  [[nodiscard]] Eigen::Vector3d normal_at(const Eigen::Vector3f& point) const noexcept;

  IndexedPoints points_;
  std::shared_ptr<const NeighborIndex> index_;
  std::size_t most_neighbors_;
  double radius_m_;
};

/// Every pixel as a point in the camera's frame, NaN where nothing was measured.
[[nodiscard]] IndexedPoints to_points(const DepthField& depth, const Intrinsics& camera);

}  // namespace telepalp::surface
