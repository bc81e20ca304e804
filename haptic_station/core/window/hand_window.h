#pragma once

#include <Eigen/Core>
#include <optional>

#include "proto/words/depth/depth_window.h"
#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"
#include "proto/words/time.h"

namespace telepalp::core {

/// Where the hand touches the device, and how fast the hand moves.
struct MovingHand {
  Point<DepthCamera> device;
  Eigen::Vector3d velocity_m_per_s = Eigen::Vector3d::Zero();  ///< of the hand, in the depth camera's frame
};

/// The part of the depth image in which the station needs exact depth: the image of all places that the hand may reach
/// within `lead`, the time from a request to the first touchable image with the requested window. These places are a
/// ball around the hand's predicted place. Its radius is 40 mm plus the distance that the hand covers in `lead`,
/// because the hand may stop or double its speed; at most 300 mm. A margin of 20 pixels is added, on which the surface
/// in the ball depends. The height is a multiple of four if the image is high enough, because such a window decodes
/// fastest. nullopt: the ball is not in front of the camera or not in its image, or a number is not finite.
[[nodiscard]] std::optional<PixelRect> hand_window(const MovingHand& hand, Nanoseconds lead, const Intrinsics& camera);

/// True if the surface at `device` is the same as without a window: the pixels that it depends on, up to 20 away from
/// the device's pixel, lie in `exact` or outside the image.
[[nodiscard]] bool covers(const PixelRect& exact, const Point<DepthCamera>& device, const Intrinsics& camera) noexcept;

}  // namespace telepalp::core
