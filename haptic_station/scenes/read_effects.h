#pragma once

#include <filesystem>

#include "haptic_station/scenes/field_check.h"
#include "haptic_station/scenes/scene.h"

namespace telepalp::scenes {

/// Reads the effects of a scene into `scene.effects` and `scene.layers`. Records the first error in `check`. Only files
/// that an effect names are read. `folder`: the scene file's folder, for relative paths.
void read_effects(FieldCheck& check, const msg::Scene& message, const std::filesystem::path& folder, Scene& scene);

}  // namespace telepalp::scenes
