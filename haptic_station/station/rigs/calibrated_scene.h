#pragma once

#include <filesystem>

#include "haptic_station/scenes/scene.h"

namespace telepalp::station {

/// The scene with its transforms replaced by those of the calibration file. With a measured camera transform, centring
/// the scene on the visible skin is turned off.
[[nodiscard]] Result<scenes::Scene> calibrated(scenes::Scene scene, const std::filesystem::path& file);

}  // namespace telepalp::station
