#pragma once

#include "haptic_station/scenes/field_check.h"
#include "haptic_station/solids/solid.h"

namespace telepalp::scenes {

/// Adds a warning to `check` for each word of a layer's solid that is valid but probably a mistake: a torus whose
/// numbers are swapped, an arc in radians, a difference or clip that takes nothing away. The place is the word's, if
/// the layer is given in Polish notation in the scene's file, else the layer's. `solid`: can be built.
void warn_about_solid(FieldCheck& check, const msg::SolidEffect& message, const solids::Solid& solid);

}  // namespace telepalp::scenes
