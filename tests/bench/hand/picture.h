#pragma once

#include <filesystem>

#include "proto/words/result.h"

namespace telepalp::bench::hand {

/// Draws the displayed force, the law's force on the true skin, and the force of an ideal display of the newest image
/// over time, as an SVG file: coughs, talk, a sit-up and percussion, at a one-way delay of 100 ms.
[[nodiscard]] Result<void> draw_force(const std::filesystem::path& file);

}  // namespace telepalp::bench::hand
