#pragma once

#include <filesystem>
#include <optional>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/rigs/static_patient.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/tracking/hand_trace.h"

namespace telepalp::station {

/// What a scene names besides its effects.
struct SceneParts {
  surface::SurfaceSettings surface;
  std::optional<tracking::HandTrace> trace;  ///< nullopt: the scene names no recorded hand
  std::optional<StaticPatient> model;        ///< nullopt: the patient is streamed
};

/// Reads the files that the scene names besides those of its effects, and no other file. `scene_file`: relative paths
/// start at its folder. `anyway`: accept a model that open_static_patient() would refuse.
[[nodiscard]] Result<SceneParts> read_parts(const scenes::Scene& scene, const std::filesystem::path& scene_file,
                                            bool anyway);

}  // namespace telepalp::station
