#pragma once

#include <filesystem>

#include "haptic_station/scenes/scene.h"

namespace telepalp::station {

/// The scene with the transforms that `file` holds in place of its own. A measured camera is not centred on what it
/// sees: it is known where it stands.
[[nodiscard]] Result<scenes::Scene> calibrated(scenes::Scene scene, const std::filesystem::path& file);

}  // namespace telepalp::station
