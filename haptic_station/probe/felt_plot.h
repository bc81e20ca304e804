#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "haptic_station/probe/touch_run.h"
#include "proto/words/result.h"

namespace telepalp::probe {

/// Plots over time, as an SVG file: the distance from the surface, the force and the computing time at each waypoint.
[[nodiscard]] Result<void> plot_felt(const std::filesystem::path& file, const std::vector<Felt>& felt,
                                     const std::string& title);

}  // namespace telepalp::probe
