#pragma once

namespace telepalp::station {

/// `telepalp-station calibrate …`: measures the transforms between tracker, camera and device, and writes them to a
/// *.calibration.textproto for `telepalp-station --calibration`. `argv[0]` is "calibrate". Returns the program's exit
/// code.
[[nodiscard]] int calibrate_command(int argc, const char* const* argv);

}  // namespace telepalp::station
