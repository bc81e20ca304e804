#pragma once

#include <array>
#include <cstdint>

#include "proto/words/rgbd_frame.h"

namespace telepalp {

/// The sRGB colour of the colour pixel that shows the same point as depth pixel (`column`, `row`). Registered images
/// show a point at the same pixel, apart from their sizes. Otherwise both cameras are taken to be at one place, because
/// the few centimetres between them are unknown: at 1 m, colours lie off by as many. `frame` is well formed, and has
/// colour.
[[nodiscard]] std::array<std::uint8_t, 3> color_at(const RgbdFrame& frame, int column, int row) noexcept;

}  // namespace telepalp
