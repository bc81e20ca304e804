#pragma once

#include <Eigen/Core>
#include <optional>

#include "haptic_station/surface/grid/window_mask.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::surface {

/// A smoothed point of the skin with its tangent plane, in the depth camera's frame.
struct SkinPoint {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();      ///< [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, towards the camera
};

struct SkinFit {
  SkinPoint point;
  double gain = 1.0;  ///< variance of the point along its normal / variance of one pixel; an upper bound
};

/// The camera over a view, whose top left pixel is the pixel (`left`, `top`) of the camera's image.
struct ViewCamera {
  const Intrinsics& camera;
  int left = 0;
  int top = 0;
};

/// Cosine between ray and normal at a point of the skin: 1 where the skin faces the camera, 0 at a silhouette.
[[nodiscard]] double facing_of(const SkinPoint& point) noexcept;

/// Fits a quadratic height over the tangent plane at `start` to the pixels of `mask`, a window of `radius` pixels
/// around (column, row). The weights fade with the distance on the skin: to zero where the window would end if the skin
/// faced the camera, and at least two and a half pixels away along the slant. The fit is repeated over the tangent
/// plane that it found, until this plane turns by less than 8 degrees. Where the quadratic's terms are not distinct, a
/// plane is fitted. nullopt: too few pixels, or no plane that faces the camera. Error: on a sphere of 80 mm, seen at
/// 0.8 m by pixels 1.5 mm apart, about 10 µm up to a slant of 70 degrees.
[[nodiscard]] std::optional<SkinFit> fit_on_skin(const InverseDepthView& view, const ViewCamera& camera,
                                                 const WindowMask& mask, Pixel centre, int radius,
                                                 const SkinPoint& start);

}  // namespace telepalp::surface
