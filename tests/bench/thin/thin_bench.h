#pragma once

#include "support/program/options.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Colour for a thin line: bytes and times of video (VP8), compared with pictures (JPEG) that are as similar to the
/// camera's images.
[[nodiscard]] Result<Report> run_thin(const program::Arguments& arguments);

}  // namespace telepalp::bench
