#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Ratio and time of each depth mode on the recording named by --input, or on the synthetic patient, and of other depth
/// codecs in the same run.
[[nodiscard]] Result<Report> run_depth(const program::Arguments& arguments);

}  // namespace telepalp::bench
