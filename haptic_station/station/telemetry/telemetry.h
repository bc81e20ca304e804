#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "haptic_station/loop/compensation.h"
#include "haptic_station/loop/tick_sample.h"
#include "haptic_station/station/threads/histogram.h"
#include "messages/station.pb.h"

namespace telepalp::station {

/// The message of the topic /station/state for one tick.
[[nodiscard]] msg::StationState state_message(const loop::TickSample& sample);

/// The message of the topic /station/compensation.
[[nodiscard]] msg::StationCompensation compensation_message(const loop::Compensation& compensation);

/// The message of the topic /station/events for a phase change at this tick. `from`: the phase before; 0 at the first
/// tick.
[[nodiscard]] msg::StationEvent phase_event(const loop::TickSample& sample, std::uint8_t from);

/// One message of the topic /station/ticks with consecutive ticks. `samples` is not empty.
[[nodiscard]] msg::StationTicks ticks_message(const std::vector<loop::TickSample>& samples, std::uint32_t period_ns);

/// Accumulates the totals of a run, tick by tick. Pure; owner: network thread.
class RunTotals {
 public:
  explicit RunTotals(std::uint32_t period_ns) noexcept : period_s_(period_ns * 1e-9) {}

  /// Whether the phase changed with a tick, and the phase before.
  struct Change {
    bool phase_changed = false;
    std::uint8_t from = 0;
  };
  Change add(const loop::TickSample& sample);
  void set_missed(std::uint64_t deadlines) noexcept { missed_ = deadlines; }
  void frame_received() noexcept { ++frames_received_; }
  void set_frames_dropped(std::uint64_t frames) noexcept { frames_dropped_ = frames; }
  void set_telemetry_dropped(std::uint64_t ticks) noexcept { telemetry_dropped_ = ticks; }

  /// The message of the topic /station/stats, without the fields that TelemetryPublisher::publish_totals() adds.
  [[nodiscard]] msg::StationStats message() const;

 private:
  struct Dwell {
    std::uint64_t entries = 0;
    std::uint64_t ticks = 0;
  };
  double period_s_;
  DurationHistogram work_;
  std::map<std::uint8_t, Dwell> dwell_;
  std::uint64_t ticks_ = 0;
  std::uint64_t missed_ = 0;
  std::uint64_t contact_ticks_ = 0;
  std::uint64_t frames_received_ = 0;
  std::uint64_t frames_dropped_ = 0;
  std::uint64_t telemetry_dropped_ = 0;
  double force_max_N_ = 0.0;
  std::uint8_t phase_ = 0;
};

}  // namespace telepalp::station
