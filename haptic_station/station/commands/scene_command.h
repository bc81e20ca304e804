#pragma once

namespace telepalp::station {

/// `telepalp-station scene check|bill|show|image|mesh SCENE`; see docs/cli.md. Returns the program's exit code.
int scene_command(int argc, const char* const* argv);

}  // namespace telepalp::station
