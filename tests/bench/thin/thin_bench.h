#pragma once

#include "support/program/options.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Colour for a thin line: bytes and times of video (VP8), compared with pictures (JPEG) that are as similar to the
/// camera's images; depth that is exact in a window, compared with depth that is exact everywhere; and what arrives at
/// a hand over a thin line, live. --part color, window, live or voice: only one of them.
[[nodiscard]] Result<Report> run_thin(const program::Arguments& arguments);

}  // namespace telepalp::bench
