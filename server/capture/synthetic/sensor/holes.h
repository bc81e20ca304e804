#pragma once

#include <cstdint>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::server {

/// In how many of 256 frames a structured-light sensor misses each pixel of the scene `depth_m`: 255 where the
/// projector's light does not arrive (it sits 75 mm beside the camera), often next to a jump in depth, sometimes on
/// skin that the ray grazes, else 0.
[[nodiscard]] std::vector<std::uint8_t> hole_map(const std::vector<float>& depth_m, const Intrinsics& camera);

}  // namespace telepalp::server
