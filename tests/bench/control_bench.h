#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// The encountered controller in virtual time: tick cost, S1's trials, force law, blind search, hand prediction on
/// real traces, limiter and watchdog.
[[nodiscard]] Result<Report> run_control(const program::Arguments& arguments);

}  // namespace telepalp::bench
