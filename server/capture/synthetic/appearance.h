#pragma once

#include <cstdint>

#include "server/capture/synthetic/shape/colleague_hand.h"
#include "server/capture/synthetic/shape/rest_shape.h"

namespace telepalp::capture {

/// Paints the colour image of the scene at full exhale: skin with mottling and pores, cloth over the pelvis, a sheet on
/// the table, lit from above the patient's left shoulder. Breathing moves the skin along the camera's rays, so the
/// image is valid at each instant of a breath; it is not valid for a body that has slid.
[[nodiscard]] ColorImage paint(const RestShape& rest, std::uint64_t seed);

/// Paints a colleague's hand over `picture`: a blue glove and a white sleeve.
void paint_glove(const ColleagueHand& hand, const Intrinsics& camera, ColorImage& picture);

}  // namespace telepalp::capture
