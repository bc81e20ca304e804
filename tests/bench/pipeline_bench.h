#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Starts the real server (synthetic patient, or --input as its source) and the real station on loopback, both with
/// keys, so that images travel by sealed datagram. Subscribes to their topics for --seconds, and measures the duration
/// of each stage of a frame's way to the hand and the timing of the 2 kHz loop.
[[nodiscard]] Result<Report> run_pipeline(const program::Arguments& arguments);

}  // namespace telepalp::bench
