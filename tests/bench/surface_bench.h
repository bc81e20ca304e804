#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// The surface's cost and steadiness against the figures asked of it, on the synthetic torso at 640×480 and on shapes
/// known by formula; ratios against the paper's own algorithm in the same run.
[[nodiscard]] Result<Report> run_surface(const program::Arguments& arguments);

}  // namespace telepalp::bench
