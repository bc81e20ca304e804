#pragma once

#include "clients/mixed/device/device_mask.h"
#include "clients/mixed/view/mask.h"

namespace telepalp::mixed {

/// How far the joint that is nearest to an end of its range is from it, as a share of the range; 0 at or beyond an end.
[[nodiscard]] double joint_room(const StandingDevice& device) noexcept;

/// Draws `live` over `image` where `where` is on, with an opacity from 0 to 1.
void draw_ghost(ColorImage& image, const ColorImage& live, const Mask& where, double opacity);

}  // namespace telepalp::mixed
