#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Error against ground truth beside cost: every setting of the surface and its parameters, what predicts hand and
/// surface, and what the depth codec's bound costs the finger. `--write docs` makes docs/accuracy.md and its plots
/// anew.
[[nodiscard]] Result<Report> run_accuracy(const program::Arguments& arguments);

}  // namespace telepalp::bench
