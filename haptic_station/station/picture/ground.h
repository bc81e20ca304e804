#pragma once

#include <span>

#include "haptic_station/solids/solid_picture.h"
#include "haptic_station/station/rigs/static_patient.h"

namespace telepalp::station {

/// A picture of the skin with a grid, without the objects inside the body. `skin`: points of a model's skin. If `skin`
/// is empty, the skin is the plane y = 0 of H: from above, skin fills the picture; from a side, it fills the part below
/// the plane. `line_px`: width of a line.
[[nodiscard]] ColorImage ground_of(const solids::PictureView& view, std::span<const SkinPoint> skin, int line_px);

}  // namespace telepalp::station
