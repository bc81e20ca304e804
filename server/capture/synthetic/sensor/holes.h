#pragma once

#include <cstdint>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::capture {

/// For each pixel, the number of frames out of 256 in which a structured-light sensor does not measure it (255: never
/// measured). It is 255 in the shadow of the projector, which is 75 mm beside the camera; high next to depth breaks;
/// moderate on skin that the ray grazes; else 0.
[[nodiscard]] std::vector<std::uint8_t> hole_map(const std::vector<float>& depth_m, const Intrinsics& camera);

}  // namespace telepalp::capture
