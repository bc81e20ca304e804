#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Studies of the force at the hand: the station's builder, loop and controller in virtual time, on moving patients,
/// behind a bad link, compared with the true skin. --row PATTERN selects the studies whose name contains PATTERN;
/// --seeds N sets the number of runs of random studies.
[[nodiscard]] Result<Report> run_hand(const program::Arguments& arguments);

}  // namespace telepalp::bench
