#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/rigs/static_patient.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/tracking/hand_trace.h"

namespace telepalp::station {

/// What a scene names besides its effects: surface setting, recorded hand and patient model.
struct SceneParts {
  surface::SurfaceSettings surface;
  std::optional<tracking::HandTrace> trace;  ///< nullopt: the scene names no recorded hand
  std::optional<StaticPatient> model;        ///< nullopt: the patient is streamed
};

/// Reads the scene's recorded hand and patient model. A relative path of the model starts at the folder of
/// `scene_file`. `anyway`: as for open_static_patient(). Error: an unknown surface setting or an unusable file.
[[nodiscard]] Result<SceneParts> read_parts(const scenes::Scene& scene, const std::filesystem::path& scene_file,
                                            bool anyway);

/// Prints the scene's warnings to stderr, each on one line: `warning: FILE:LINE:COLUMN: WHAT. fix: FIX`.
void print_warnings(const scenes::Scene& scene);

/// "palpation: the scene is valid; PURPOSE; effects: skin, cylinder", without a line break.
[[nodiscard]] std::string validity_in_words(const scenes::Scene& scene);

}  // namespace telepalp::station
