#pragma once

#include <cstdint>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::capture {

/// For each pixel, the number of frames out of 256 in which a structured-light sensor does not measure it (255: never
/// measured). It is 255 in the shadow of the projector, which is 75 mm to the camera's right; 120 to 220 within 2
/// pixels of a silhouette; 100 where the ray grazes the skin; else 0. `depth_m`: depth [m] of each pixel, row by row.
[[nodiscard]] std::vector<std::uint8_t> hole_map(const std::vector<float>& depth_m, const Intrinsics& camera);

}  // namespace telepalp::capture
