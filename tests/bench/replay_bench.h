#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// telepalp-replay: its speed on a session, a simulated patient and an .oni, what a grid costs beside one run, whether
/// threads change anything, and how closely the same run between real sockets agrees.
[[nodiscard]] Result<Report> run_replay(const program::Arguments& arguments);

}  // namespace telepalp::bench
