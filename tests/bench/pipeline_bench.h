#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Starts the real server (synthetic patient, or --input as its source) and the real station on loopback, listens to
/// them for --seconds as any subscriber would, and tells how long each stage of a frame's way to the hand takes and
/// how the 2 kHz loop keeps its time meanwhile.
[[nodiscard]] Result<Report> run_pipeline(const program::Arguments& arguments);

}  // namespace telepalp::bench
