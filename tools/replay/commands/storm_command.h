#pragma once

#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// Runs the cases of the seeds 1 to N on all threads. Each case that fails is shrunk, and the command line that repeats
/// it is printed. True: the invariants held in all of them.
[[nodiscard]] Result<bool> run_storm(const Request& request);

}  // namespace telepalp::replay
