#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Measures error against ground truth, and cost: of every surface setting and parameter, of the predictions of hand
/// and surface, and of the depth codec's error bound. `--write docs` rewrites docs/accuracy.md and its plots.
[[nodiscard]] Result<Report> run_accuracy(const program::Arguments& arguments);

}  // namespace telepalp::bench
