#pragma once

#include "clients/mixed/device/device_mask.h"
#include "clients/mixed/view/mask.h"

namespace telepalp::mixed {

/// Distance of a joint from the nearer end of its range, as a share of the range: the least of all joints, from 0 (at
/// or beyond an end) to 0.5.
[[nodiscard]] double joint_room(const StandingDevice& device) noexcept;

/// A channel `opacity` of the way from `under` to `over`: `under` at 0, `over` at 1.
[[nodiscard]] std::uint8_t blended(std::uint8_t under, std::uint8_t over, double opacity) noexcept;

/// Draws `live` over `image` where `where` is on, with an opacity from 0 to 1.
void draw_ghost(ColorImage& image, const ColorImage& live, const Mask& where, double opacity);

}  // namespace telepalp::mixed
