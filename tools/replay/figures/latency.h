#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/replay/cell/station_output.h"

namespace telepalp::replay {

/// The stages of a frame, from one of its five instants to the next, and their sum.
inline constexpr std::array kLatencyStages{"captured to encoded", "encoded to received", "received to decoded",
                                           "decoded to touchable", "captured to touchable"};
inline constexpr std::size_t kStageCount = kLatencyStages.size();
inline constexpr std::size_t kNetworkStage = 1;
inline constexpr std::size_t kTotalStage = 4;

/// Duration of one stage over all frames that became a surface; NaN if there was none.
struct StageLatency {
  double p50_s = 0.0;
  double p99_s = 0.0;
  double max_s = 0.0;
};
using LatencyBreakdown = std::array<StageLatency, kStageCount>;  ///< in the order of kLatencyStages

/// The time between two instants of the session clock [s].
[[nodiscard]] inline float seconds_between(std::int64_t from_ns, std::int64_t to_ns) noexcept {
  return static_cast<float>(1e-9 * static_cast<double>(to_ns - from_ns));
}

/// Collects the instants of a run's frames.
class LatencySum {
 public:
  void add(const FrameTimes& times);
  [[nodiscard]] LatencyBreakdown breakdown() const;

 private:
  std::array<std::vector<float>, kStageCount> stages_s_;
};

/// A table in milliseconds with one row for each stage: the unimpaired run, and this run.
[[nodiscard]] std::string latency_table(const LatencyBreakdown& unimpaired, const LatencyBreakdown& run);

}  // namespace telepalp::replay
