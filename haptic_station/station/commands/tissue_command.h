#pragma once

namespace telepalp::station {

/// `telepalp-station tissue`: fits the skin's law to a compression test, tells the fit's error, and prints the lines
/// for a scene; without a test, the presets and theirs. `argv[0]` is "tissue".
int tissue_command(int argc, const char* const* argv);

}  // namespace telepalp::station
