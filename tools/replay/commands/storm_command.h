#pragma once

#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// Runs a storm on `request.threads` threads: the random cases (patient, scene, hand's script, network, faults) of
/// `request.storm_seeds` successive seeds from `request.scenario.seed` on. Shrinks each case that fails (shrunk() in
/// storm.h), and prints the command line of the shrunk case. True: the invariants held in all cases.
[[nodiscard]] Result<bool> run_storm(const Request& request);

}  // namespace telepalp::replay
