#pragma once

namespace telepalp::station {

/// `telepalp-station rearm`: asks the running station to end its fault, so that it gives force again. `argv[0]` is
/// "rearm". Returns the program's exit code.
int rearm_command(int argc, const char* const* argv);

}  // namespace telepalp::station
