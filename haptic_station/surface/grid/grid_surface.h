#pragma once

#include <span>

#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::surface {

/// One point of the organised surface, one cache line: a smoothed point, its normal and how it moves.
struct alignas(64) GridNode {
  std::array<float, 3> at_m{};    ///< relative to the grid's origin
  float confidence = 0.0F;        ///< 0: no surface at this node
  std::array<float, 3> normal{};  ///< unit, towards the camera
  float deviation_m = 0.0F;       ///< 1-sigma of the position along the normal
  MotionTerms motion{};           ///< [m/s, m, m, m, m] along the normal
  std::array<float, 3> spare{};
};
static_assert(sizeof(GridNode) == 64);

/// Where the nodes lie: every `step` pixels from (left, top) of the camera's image.
struct GridLayout {
  Intrinsics camera;
  double left_px = 0.0;
  double top_px = 0.0;
  double step_px = 1.0;
  int columns = 0;
  int rows = 0;
  double support_nodes = 2.5;  ///< radius of the weights, in nodes
  double gate_m = 0.02;        ///< a node whose tangent plane is farther than this from the query is another surface
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
};

/// The organised index: a depth image already is a spatial one. Neighbours are the nodes around the query's pixel, so a
/// query costs the same wherever it is, and slanted skin is met with the density it was seen with.
///
/// Each node's tangent plane is averaged with the mean plane, f = Σ w ½(n_i + n̄)·(x − p_i) / Σ w: exact on any quadric
/// to third order where either alone is off by curvature × support² / 4 (for a sphere chord and bisecting normal are at
/// right angles). C1: the weights fade in the image plane, whose coordinates are smooth in x.
/// Borrows `nodes`; whoever owns this keeps them alive.
class GridSurface : public SurfaceSnapshot {
 public:
  [[nodiscard]] FieldSample evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d& facing,
                                     const MotionBasis& basis) const noexcept final;
  [[nodiscard]] std::optional<Seed> seed(const Eigen::Vector3d& query) const noexcept final;
  [[nodiscard]] double stride_m(const Eigen::Vector3d& query) const noexcept final;
  void prefetch(const Eigen::Vector3d& query) const noexcept final;
  [[nodiscard]] const GridLayout& layout() const noexcept { return layout_; }
  [[nodiscard]] std::span<const GridNode> nodes() const noexcept { return nodes_; }

 protected:
  ~GridSurface() = default;
  GridLayout layout_;
  std::span<const GridNode> nodes_;  ///< rows × columns
};

}  // namespace telepalp::surface
