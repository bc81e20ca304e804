#pragma once

#include <filesystem>

#include "haptic_station/scenes/field_check.h"
#include "haptic_station/scenes/scene.h"
#include "messages/scene.pb.h"

namespace telepalp::scenes {

/// The node spacing of a mesh's lattice for which the scene gives `cell_m`.
[[nodiscard]] double cell_with(MeshDetail detail, double cell_m) noexcept;

/// Reads a layer of the scene, a solid inside the body: its tree of shapes and operators in the scene's text format or
/// in Polish notation, its pose in H, and what it feels like. Records the first error in `check` and then returns a
/// recipe without layer; reads files only when the numbers are valid. `folder`: the scene file's, for relative paths.
[[nodiscard]] effects::SolidSettings read_layer(FieldCheck& check, const msg::SolidEffect& message,
                                                const std::filesystem::path& folder, MeshDetail detail);

}  // namespace telepalp::scenes
