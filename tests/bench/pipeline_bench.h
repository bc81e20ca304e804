#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

struct PipelineRun {
  std::string source = "synthetic";  ///< as telepalp-server --source
  std::string depth_mode = "fast";
  double seconds = 10.0;
};

/// Starts the real server and the real station on loopback, both with keys, so that images travel by sealed datagram.
/// Subscribes to their topics, and measures the duration of each stage of a frame's way to the hand and the timing of
/// the 2 kHz loop.
[[nodiscard]] Result<Report> measure_pipeline(const PipelineRun& run);

/// measure_pipeline() by --input, --depth-mode and --seconds.
[[nodiscard]] Result<Report> run_pipeline(const program::Arguments& arguments);

}  // namespace telepalp::bench
