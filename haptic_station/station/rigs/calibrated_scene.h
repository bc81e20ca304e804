#pragma once

#include <filesystem>

#include "haptic_station/scenes/scene.h"

namespace telepalp::station {

/// The scene with the transforms that the calibration file holds. A measured camera transform also turns off
/// Scene::center_on_surface. Error: the file is unreadable, or holds no transform or an invalid one.
[[nodiscard]] Result<scenes::Scene> calibrated(scenes::Scene scene, const std::filesystem::path& file);

}  // namespace telepalp::station
