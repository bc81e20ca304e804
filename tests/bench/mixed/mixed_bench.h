#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// The mixed view on a rendered desk: calibration, masks, background, hand, time, anchoring, thresholds.
[[nodiscard]] Result<Report> run_mixed(const program::Arguments& arguments);

}  // namespace telepalp::bench
