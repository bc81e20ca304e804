#pragma once

namespace telepalp::station {

/// `telepalp-station tissue`: fits the skin's force law to a compression test and prints the fit's error and the lines
/// for a scene file. Without a test the command prints the presets and their fit errors. `argv[0]` is "tissue". Returns
/// the program's exit code.
int tissue_command(int argc, const char* const* argv);

}  // namespace telepalp::station
