#pragma once

#include "proto/words/frames.h"

namespace telepalp::scenes {

/// `haptic_from_camera` shifted, not turned, so that `skin` (a point of the patient's surface, such as the one under
/// the image centre) becomes H's origin. A scene placed for one camera height then suits every other.
[[nodiscard]] inline Transform<HapticBase, DepthCamera> centered_on(
    const Transform<HapticBase, DepthCamera>& haptic_from_camera, const Point<DepthCamera>& skin) noexcept {
  Transform<HapticBase, DepthCamera> centered = haptic_from_camera;
  centered.iso.translation() -= (haptic_from_camera * skin).m;
  return centered;
}

}  // namespace telepalp::scenes
