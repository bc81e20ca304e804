#pragma once

namespace telepalp::station {

/// `telepalp-station scene check|bill|show|image|mesh FILE`: what a scene holds, costs and looks like. See docs/cli.md.
int scene_command(int argc, const char* const* argv);

}  // namespace telepalp::station
