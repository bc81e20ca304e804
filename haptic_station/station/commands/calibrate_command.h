#pragma once

namespace telepalp::station {

/// `telepalp-station calibrate …`: measures where tracker, camera and device stand to one another, and keeps it in a
/// *.calibration.textproto that `--calibration` reads. Returns the program's exit code.
[[nodiscard]] int calibrate_command(int argc, const char* const* argv);

}  // namespace telepalp::station
