#pragma once

namespace telepalp::station {

/// `telepalp-station rearm`: an operator lets a faulted station touch again. `argv[0]` is "rearm".
int rearm_command(int argc, const char* const* argv);

}  // namespace telepalp::station
