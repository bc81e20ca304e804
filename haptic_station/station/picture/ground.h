#pragma once

#include <span>

#include "haptic_station/solids/solid_picture.h"
#include "haptic_station/station/rigs/static_patient.h"

namespace telepalp::station {

/// The skin with a grid, without the objects below it. `skin`: points of a model's skin; without any, the skin is the
/// plane y = 0 of H: all of a picture from above; from a side, all below the plane. `line_px`: width of a line.
[[nodiscard]] ColorImage ground_of(const solids::PictureView& view, std::span<const SkinPoint> skin, int line_px);

}  // namespace telepalp::station
