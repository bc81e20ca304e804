#pragma once

#include <Eigen/Core>
#include <optional>

#include "proto/words/depth/depth_window.h"
#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"
#include "proto/words/time.h"

namespace telepalp::core {

/// Where the device is touched, and how fast the hand moves.
struct MovingHand {
  Point<DepthCamera> device;
  Eigen::Vector3d velocity_m_per_s = Eigen::Vector3d::Zero();  ///< of the hand, in the depth camera's frame
};

/// The part of the depth image in which the station needs exact depth: the projection of the ball that the hand can
/// reach within `lead`, the time until images of a window that is asked for now are touchable. The ball lies around the
/// predicted hand. Its radius is 40 mm and the way that the hand makes in `lead`, as it may stop, or become twice as
/// fast; at most 300 mm. Around it lie 20 pixels on which the surface in the ball depends. The height is a multiple of
/// four where the image allows, which decodes fastest. nullopt: the ball is not in front of the camera, or is outside
/// its image, or a number is not finite.
[[nodiscard]] std::optional<PixelRect> hand_window(const MovingHand& hand, Nanoseconds lead, const Intrinsics& camera);

/// True if the surface at `device` is the same as without a window: the pixels that it depends on, up to 20 away from
/// the device's pixel, lie in `exact` or outside the image.
[[nodiscard]] bool covers(const PixelRect& exact, const Point<DepthCamera>& device, const Intrinsics& camera) noexcept;

}  // namespace telepalp::core
