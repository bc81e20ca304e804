#pragma once

#include <string>

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Adds bytes and times of depth that is exact in a window of 15 % of the image, compared with depth that is exact
/// everywhere. `inputs`: sets of depth images, separated by commas; empty: the recorded room and the synthetic patient.
[[nodiscard]] Result<void> add_window_rows(Report& report, const std::string& inputs);

}  // namespace telepalp::bench
