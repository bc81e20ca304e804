#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Needles in layers of tissue: time of a tick, energy, steps of the force, relaxation, and with --input also the fit
/// to measured insertions.
[[nodiscard]] Result<Report> run_needle(const program::Arguments& arguments);

}  // namespace telepalp::bench
