#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// The rows of run_subscribers(), of at least `seconds` / 10 rounds.
void add_subscribers(Report& report, double seconds);

/// Measures the server's cost of a further subscriber, as a ratio to a bare send of the same bytes; the shares of 200
/// subscribers on the loopback; and the delay that a stalled subscriber causes to the others. Real sockets on loopback.
[[nodiscard]] Result<Report> run_subscribers(const program::Arguments& arguments);

}  // namespace telepalp::bench
