#pragma once

#include <span>

#include "haptic_station/surface/depth/block_depths.h"

namespace telepalp::surface {

/// True if the bed and the body on it came nearer, or went farther, together by more than 12 mm from the blocks' depths
/// `before_m` to `seen_m` [m]; 0: unknown. A patient moves on a bed that rests, so then the camera moved. The bed is
/// what lies more than 60 mm deeper than the middle of what is seen, if that is flat; where no bed is seen, the answer
/// is false. A camera that moves along its image plane is not detected.
[[nodiscard]] bool camera_moved(const BlockLattice& lattice, std::span<const float> before_m,
                                std::span<const float> seen_m);

}  // namespace telepalp::surface
