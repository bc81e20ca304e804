#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Measures telepalp-replay: its speed on a session, a simulated patient and an .oni recording, the cost of a sweep
/// relative to one run, whether the number of threads changes results, and how closely a run over real sockets agrees.
[[nodiscard]] Result<Report> run_replay(const program::Arguments& arguments);

}  // namespace telepalp::bench
