#pragma once

#include <memory>
#include <optional>

#include "haptic_station/surface/cloud/kdtree_index.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// The surface exactly as paper S1 §II.C (docs/sources.md) defines it: the slow reference for the other surfaces. A
/// query x uses up to N points within the radius R (SurfaceSettings: `neighbors`, `radius_m`). Each of them gets a
/// normal, towards the camera, by principal component analysis of its own N neighbours within R. The implicit function
/// is Adamson and Alexa's f = n̄·(x − ā), with the weighted mean normal n̄ and mean point ā and Wyvill's soft-object
/// weights of influence radius R. As in S1, n̄ replaces the gradient. Defect: f jumps when another point becomes the
/// N-th neighbour, because its weight is not zero (telepalp-bench surface measures the jump). Its searches allocate.
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

/// Back-projects every pixel to a point in the depth camera's frame; unmeasured pixels become NaN.
[[nodiscard]] IndexedPoints to_points(const DepthField& depth, const Intrinsics& camera);

}  // namespace telepalp::surface
