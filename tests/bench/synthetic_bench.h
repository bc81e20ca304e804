#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// What the synthetic patient costs at 640x480 and 30 Hz, and how far its depth lies from its truth.
[[nodiscard]] Result<Report> run_synthetic(const program::Arguments& arguments);

}  // namespace telepalp::bench
