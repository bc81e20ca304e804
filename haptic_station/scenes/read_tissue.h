#pragma once

#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/scenes/field_check.h"

namespace telepalp::scenes {

/// Reads layers of tissue and solves their net. Records the first error in `check` and then returns a recipe without
/// tissue.
[[nodiscard]] effects::LayeredTissueSettings read_layered_tissue(FieldCheck& check,
                                                                 const msg::LayeredTissueEffect& message);

/// Reads a prism and solves for its material. Records the first error in `check` and then returns a recipe without
/// prism.
[[nodiscard]] effects::FemPrismSettings read_prism(FieldCheck& check, const msg::FemPrismEffect& message);

}  // namespace telepalp::scenes
