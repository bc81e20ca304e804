#include "tools/replay/figures/latency.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tools/replay/figures/quantile.h"

namespace telepalp::replay {
namespace {

std::string cells(const StageLatency& stage) {
  std::string text;
  for (const double value_s : {stage.p50_s, stage.p99_s, stage.max_s}) {
    std::array<char, 32> cell{};
    if (std::isfinite(value_s))
      std::snprintf(cell.data(), cell.size(), "%9.2f", 1e3 * value_s);
    else
      std::snprintf(cell.data(), cell.size(), "%9s", "unknown");
    text += cell.data();
  }
  return text;
}

}  // namespace

void LatencySum::add(const FrameTimes& times) {
  const std::array instants_ns{times.captured_ns, times.encoded_ns, times.received_ns, times.decoded_ns,
                               times.touchable_ns};
  for (std::size_t stage = 0; stage + 1 < instants_ns.size(); ++stage)
    stages_s_[stage].push_back(seconds_between(instants_ns[stage], instants_ns[stage + 1]));
  stages_s_.back().push_back(seconds_between(times.captured_ns, times.touchable_ns));
}

LatencyBreakdown LatencySum::breakdown() const {
  LatencyBreakdown breakdown;
  for (std::size_t stage = 0; stage < kStageCount; ++stage)
    breakdown[stage] = {.p50_s = quantile(stages_s_[stage], 0.5),
                        .p99_s = quantile(stages_s_[stage], 0.99),
                        .max_s = quantile(stages_s_[stage], 1.0)};
  return breakdown;
}

std::string latency_table(const LatencyBreakdown& unimpaired, const LatencyBreakdown& run) {
  std::string text =
      "latency of each stage, for the frames that became a surface [ms]\n                        unimpaired            "
      "     "
      "this run\n"
      "                           p50      p99      max      p50      p99      max\n";
  for (std::size_t stage = 0; stage < kStageCount; ++stage) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "%-21s", kLatencyStages[stage]);
    text += name.data() + cells(unimpaired[stage]) + cells(run[stage]) + "\n";
  }
  return text;
}

}  // namespace telepalp::replay
