#pragma once

#include <filesystem>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "messages/journal.pb.h"

namespace telepalp::station {

/// The header of a journal: this program, this machine, and the scene as the station uses it. `file`: of the scene.
[[nodiscard]] msg::JournalHeader journal_header(const scenes::Scene& scene, const std::filesystem::path& file,
                                                const surface::SurfaceSettings& surface);

/// The scene and the surface setting of a journal.
struct JournaledScene {
  scenes::Scene scene;
  surface::SurfaceSettings surface;
};
/// Error: a file that the scene names cannot be read, or the header is malformed.
[[nodiscard]] Result<JournaledScene> journaled_scene(const msg::JournalHeader& header);

/// The model of this machine's processor; empty: unknown.
[[nodiscard]] std::string processor_model();

}  // namespace telepalp::station
