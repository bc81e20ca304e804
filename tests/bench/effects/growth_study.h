#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// How the cost grows with the number of separated solids, from 10 to 10 000: of a step of the proxy that a finger
/// drags along, of an evaluation at the finger's places, and of one at scattered places. Many scattered places read
/// more data than the core's second-level cache holds; a few of them fit, so their cost has no cache misses.
void measure_growth(Report& report);

}  // namespace telepalp::bench
