#pragma once

#include "support/program/options.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// What a thin line is given: colour as video (VP8) beside pictures (JPEG), at equal similarity to the camera's images.
[[nodiscard]] Result<Report> run_thin(const program::Arguments& arguments);

}  // namespace telepalp::bench
