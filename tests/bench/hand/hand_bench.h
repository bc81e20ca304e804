#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// The hand's truth: the product's builder, loop and controller in virtual time, on patients who move, behind a bad
/// link, measured against the true skin. --row PATTERN runs the studies whose name contains PATTERN, --seeds N the
/// number of runs where a study draws.
[[nodiscard]] Result<Report> run_hand(const program::Arguments& arguments);

}  // namespace telepalp::bench
