#pragma once

#include "haptic_station/scenes/field_check.h"
#include "haptic_station/scenes/scene.h"

namespace telepalp::scenes {

/// Adds a warning to `check` for each part of the scene that is valid and yet hardly meant: an object that is huge,
/// far away, too deep, above the skin, around the hand, empty, too soft or there twice; a camera that does not look
/// down on the patient; friction on a skin that does not slide. `message`: from which `scene` was read.
void warn_about_scene(FieldCheck& check, const msg::Scene& message, const Scene& scene);

}  // namespace telepalp::scenes
