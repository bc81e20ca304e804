#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "haptic_station/station/telemetry/telemetry.h"
#include "haptic_station/station/threads/haptic_thread.h"
#include "proto/wire/message.h"
#include "proto/words/frames.h"

namespace telepalp::station {

/// Reads the ring of ticks and publishes messages: all ticks in batches, the state at the first tick of each 10 ms of
/// session time, an event at each phase change, and the run's totals (StationStats). Owner: network thread.
class TelemetryPublisher {
 public:
  using Publish = std::function<void(wire::Message)>;
  using OnTick = std::function<void(const loop::TickSample&)>;  ///< called with every tick, in order

  TelemetryPublisher(TickRing& ticks, Publish publish, OnTick on_tick);

  /// Publishes what the class comment lists for all ticks in the ring. Call it about 100 times a second.
  void drain(SessionTime now);

  /// Publishes the totals so far. `clock_error_s`: bound on the error of `now`. `bill`: computing time of each effect.
  void publish_totals(SessionTime now, double clock_error_s, const HapticCounts& counts, std::uint64_t frames_dropped,
                      bool realtime, const std::vector<msg::EffectCost>& bill);

  /// Adds to the totals the wake-up latency of an otherwise idle thread on this computer; see watch_idle_timer().
  void set_idle_timer(const msg::TimerCheck& check) { idle_timer_ = check; }

  /// Adds to the totals the calibration with which the tracker's hands are placed in the haptic base's frame H.
  void set_calibration(const Transform<HapticBase, HandTracker>& haptic_from_tracker);

  /// Adds to the totals the station's name, version and commit.
  void set_software(std::string software) { software_ = std::move(software); }

  /// Publishes an event.
  void publish_event(SessionTime now, msg::EventKind kind, const std::string& text);

  /// Publishes a warning 4 s before the warm motors can no longer hold the contact force. Warns again only after the
  /// contact has ended, or its force has been one that the motors hold without time limit.
  void watch_heat(SessionTime now);

  void frame_received() noexcept { totals_.frame_received(); }
  [[nodiscard]] const loop::TickSample& last() const noexcept { return last_; }
  [[nodiscard]] bool has_ticked() const noexcept { return has_ticked_; }

 private:
  bool begins_state_period(const loop::TickSample& tick);

  TickRing& ticks_;
  Publish publish_;
  OnTick on_tick_;
  RunTotals totals_;
  std::vector<loop::TickSample> batch_;
  loop::TickSample last_;
  std::optional<msg::TimerCheck> idle_timer_;
  std::optional<msg::RigidMotion> haptic_from_tracker_;
  std::string software_;
  std::int64_t state_period_ = -1;  // number of the last published state's 10 ms period since session time 0
  bool has_ticked_ = false;
  bool heat_warned_ = false;
};

}  // namespace telepalp::station
