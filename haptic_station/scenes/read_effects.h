#pragma once

#include <filesystem>

#include "haptic_station/scenes/field_check.h"
#include "haptic_station/scenes/scene.h"

namespace telepalp::scenes {

/// Reads the recipes of a scene's effects, with the files that the effects name. Records the first error in `check`.
/// `folder`: the scene file's folder, for relative paths.
[[nodiscard]] std::vector<effects::Recipe> read_effects(FieldCheck& check, const msg::Scene& message,
                                                        const std::filesystem::path& folder, MeshDetail detail);

}  // namespace telepalp::scenes
