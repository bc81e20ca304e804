#pragma once

#include <filesystem>

#include "clients/mixed/scene/desk_props.h"
#include "proto/words/result.h"

namespace telepalp::mixed {

/// Writes a folder that read_sequence() reads: a rendered desk, an Omni on it, and a hand that presses a virtual tool
/// against something stiff, so that the device sinks `gap_m` below the tool. In the last third of the frames the
/// markers are lost. `background`, `frames`: numbers of images. `proxy`: the surface that stands for the background.
/// Also writes clicks.csv and touches.csv: simulated clicks to calibrate with, and simulated touches to anchor a
/// headset with.
[[nodiscard]] Result<void> write_rendered_sequence(const std::filesystem::path& folder, int background, int frames,
                                                   double gap_m, ProxyKind proxy);

}  // namespace telepalp::mixed
