#pragma once

#include <optional>

#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::station {

/// The surface point under the middle of the image: on the central ray, at the median depth of the smallest centred
/// window in which at least half of the pixels are measured. nullopt when no such window is within the image.
[[nodiscard]] std::optional<Point<DepthCamera>> point_under_center(const DepthImage& depth, const Intrinsics& camera);

}  // namespace telepalp::station
