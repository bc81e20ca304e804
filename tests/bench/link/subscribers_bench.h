#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// What a further subscriber costs the server beside a bare send of the same bytes, how 200 share the loopback, and
/// what a stalled one costs the others. Real sockets on loopback.
[[nodiscard]] Result<Report> run_subscribers(const program::Arguments& arguments);

}  // namespace telepalp::bench
