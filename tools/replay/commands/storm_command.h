#pragma once

#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// Runs a storm on all threads: the random cases (patient, scene, network, faults) of the seeds 1 to N. Shrinks each
/// case that fails, and prints the command line of the shrunk case. True: the invariants held in all cases.
[[nodiscard]] Result<bool> run_storm(const Request& request);

}  // namespace telepalp::replay
