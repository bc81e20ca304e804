#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// 1000 seeded runs of a hand on a breathing skin behind a bad link, each of --seconds (the requirement is for 60; the
/// default of 10 takes about a minute), and the force error under delay alone.
[[nodiscard]] Result<Report> run_passivity(const program::Arguments& arguments);

}  // namespace telepalp::bench
