#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// telepalp-replay: its speed, what a grid costs beside one run, and whether threads change anything.
[[nodiscard]] Result<Report> run_replay(const program::Arguments& arguments);

}  // namespace telepalp::bench
