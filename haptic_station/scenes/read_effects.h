#pragma once

#include <filesystem>

#include "haptic_station/scenes/field_check.h"
#include "haptic_station/scenes/scene.h"

namespace telepalp::scenes {

/// Reads the effects of a scene into `effects`, `layers` and `organs` of `scene`, with the files that the effects name.
/// Records the first error in `check`. `folder`: the scene file's folder, for relative paths.
void read_effects(FieldCheck& check, const msg::Scene& message, const std::filesystem::path& folder, Scene& scene);

}  // namespace telepalp::scenes
