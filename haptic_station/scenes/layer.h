#pragma once

#include <filesystem>

#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/scenes/field_check.h"
#include "messages/scene.pb.h"

namespace telepalp::scenes {

/// Reads a layer of the scene, a solid inside the body: its tree of shapes and operators in the scene's text format or
/// in Polish notation, its pose in H, and what it feels like. Records the first error in `check` and then returns an
/// effect without layer; reads files only when the numbers are valid. `folder`: the scene file's, for relative paths.
[[nodiscard]] effects::Solid read_layer(FieldCheck& check, const msg::SolidEffect& message,
                                        const std::filesystem::path& folder);

}  // namespace telepalp::scenes
