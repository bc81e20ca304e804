#pragma once

#include <filesystem>

#include "proto/words/result.h"

namespace telepalp::bench {

/// Number of turns with a recorder, and of turns without one. All have equal length.
inline constexpr int kRecordingTurns = 5;

/// What recording a live session costs. Shares are of one core.
struct RecordingCost {
  double recorder_share = 0.0;  ///< processor time of the recorder
  double server_share = 0.0;    ///< processor time of the server with a recorder, less that without
  double alone_us = 0.0;        ///< time spent in a tick without a recorder: median over the turns of their p99.9
  double recorded_us = 0.0;     ///< the same with a recorder
};

/// Runs server and station on the synthetic patient for about `seconds`, in turns with and without a recorder that
/// records all topics into `folder`. Error: a program does not start.
[[nodiscard]] Result<RecordingCost> recording_cost(const std::filesystem::path& folder, double seconds);

}  // namespace telepalp::bench
