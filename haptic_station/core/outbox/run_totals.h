#pragma once

#include <cstdint>
#include <map>

#include "haptic_station/core/outbox/duration_histogram.h"
#include "haptic_station/loop/tick_sample.h"
#include "messages/station.pb.h"

namespace telepalp::core {

/// Accumulates the totals of a run, tick by tick. Owner: one thread.
class RunTotals {
 public:
  /// Whether the phase changed with a tick, and the phase before.
  struct Change {
    bool phase_changed = false;
    std::uint8_t from = 0;
  };
  Change add(const loop::TickSample& sample);
  void frame_received() noexcept { ++frames_received_; }

  /// The message of the topic /station/stats, without the fields that Outbox::totals() adds.
  [[nodiscard]] msg::StationStats message() const;

 private:
  struct Dwell {
    std::uint64_t entries = 0;
    std::uint64_t ticks = 0;
  };
  DurationHistogram work_;
  std::map<std::uint8_t, Dwell> dwell_;
  std::uint64_t ticks_ = 0;
  std::uint64_t contact_ticks_ = 0;
  std::uint64_t frames_received_ = 0;
  double force_max_N_ = 0.0;
  std::uint8_t phase_ = 0;
};

}  // namespace telepalp::core
