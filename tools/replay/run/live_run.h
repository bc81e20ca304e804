#pragma once

#include <functional>

#include "tools/replay/run/session_run.h"

namespace telepalp::replay {

/// A network that the caller provides, and its clock.
struct LiveNetwork {
  Wires wires;
  std::function<void(Nanoseconds)> await;  ///< returns when this time since the session's start has come
};

/// Runs the tape once over `network`, at the pace of `network.await`: the same run as run_session() makes of
/// `scenario`, with a real network in place of the simulated one. Reads all frames of the run from the tape before
/// the run begins. `settings.seconds` is above 0. `unimpaired`: the ticks of the run without impairments, with which
/// the ticks of this run are compared one by one; after the last, the run ends. Error: the tape cannot be read, or the
/// scene can be placed in no frame.
[[nodiscard]] Result<RunResult> run_live(Tape& tape, const RunSettings& settings, const Scenario& scenario,
                                         LiveNetwork network, const std::vector<TickRecord>& unimpaired);

}  // namespace telepalp::replay
