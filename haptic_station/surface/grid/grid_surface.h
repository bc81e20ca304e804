#pragma once

#include <span>

#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::surface {

/// One node of the lattice (GridLayout), in one cache line: a smoothed point with its normal and its motion.
struct alignas(64) GridNode {
  std::array<float, 3> at_m{};    ///< relative to GridLayout::origin_m
  float confidence = 0.0F;        ///< 0: no surface at this node
  std::array<float, 3> normal{};  ///< unit, towards the camera
  float deviation_m = 0.0F;       ///< standard deviation of `at_m` along the normal
  MotionTerms motion{};           ///< coefficients [m/s, m, m, m, m, m/s, m] of its motion along the normal
  float spare = 0.0F;             ///< fills the cache line
};
static_assert(sizeof(GridNode) == 64);

/// The lattice of nodes: one node every `step_px` pixels of the camera's image, from (`left_px`, `top_px`) on.
struct GridLayout {
  Intrinsics camera;
  double left_px = 0.0;
  double top_px = 0.0;
  double step_px = 1.0;
  int columns = 0;
  int rows = 0;
  double support_nodes = 2.5;  ///< a node farther than this from the query's pixel has no weight [units of step_px]
  double gate_m = 0.02;        ///< a node is ignored when its tangent plane is farther than this from the query
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
};

/// An implicit surface over a depth image, whose pixel grid serves as the spatial index. The neighbours of a query are
/// the nodes around its pixel, so every query takes the same time, and the spacing of nodes on slanted skin is
/// proportional to the spacing of the camera's samples.
///
/// Each node's tangent plane is averaged with the mean plane: f = Σ w ½(n_i + n̄)·(x − p_i) / Σ w, with the query x,
/// the node i at p_i with normal n_i and weight w, and n̄ the unit vector of Σ w n_i. On any quadric, the surface f = 0
/// is exact to third order, while the surface of the node planes alone, or of the mean plane alone, errs by curvature ×
/// support² / 4 [m]. The reason: on a sphere, the line from p_i to a surface point x is perpendicular to the sum of the
/// normals at p_i and x, and n̄ approximates the normal at x. f is continuously differentiable (C1), because the
/// weights fade smoothly in the image plane, whose coordinates are smooth functions of x.
///
/// Does not own `nodes`; the derived class keeps them alive.
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
  std::span<const GridNode> nodes_;  ///< rows × columns, row by row
};

}  // namespace telepalp::surface
