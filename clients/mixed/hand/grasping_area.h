#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "clients/mixed/view/view.h"

namespace telepalp::mixed {

/// The image of the space around the handle in which the hand grasps it: two hexagons around the line from `a` to `b`.
/// A hexagon of width w has two sides parallel to the line, w / 2 from it, and a corner w / 2 beyond each end.
struct GraspingArea {
  Eigen::Vector2d a = Eigen::Vector2d::Zero();  ///< end of the handle's line [px]
  Eigen::Vector2d b = Eigen::Vector2d::Zero();  ///< its other end [px]
  double outer_px = 0.0;                        ///< width of the outer hexagon, L_o
  double inner_px = 0.0;                        ///< width of the inner hexagon, L_i

  /// 1 in the inner hexagon, 0 outside the outer one, with a smooth step between them.
  [[nodiscard]] double weight_at(const Eigen::Vector2d& pixel) const noexcept;
  /// The corners of a hexagon of this width, in order.
  [[nodiscard]] std::array<Eigen::Vector2d, 6> corners(double width_px) const noexcept;
};

/// Paper S3 (docs/sources.md) eq. (2): L_o = max(0.75 L_AB, 0.1 D), L_i = 0.2 L_o, with the viewport's diagonal D.
/// nullopt if an end of the handle is behind the camera.
[[nodiscard]] std::optional<GraspingArea> grasping_area(const View& view, const Point<World>& from,
                                                        const Point<World>& to) noexcept;

}  // namespace telepalp::mixed
