#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Needles in layers of tissue: time, energy, force steps, relaxation.
[[nodiscard]] Result<Report> run_needle(const program::Arguments& arguments);

}  // namespace telepalp::bench
