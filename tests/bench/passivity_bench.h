#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// 1000 seeded runs of a hand on a breathing skin behind a bad link, each --seconds long (60 is the figure that is
/// asked for; the default of 10 takes about a minute), and the force error that plain delay leaves.
[[nodiscard]] Result<Report> run_passivity(const program::Arguments& arguments);

}  // namespace telepalp::bench
