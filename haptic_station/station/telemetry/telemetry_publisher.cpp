#include "haptic_station/station/telemetry/telemetry_publisher.h"

#include <cmath>
#include <utility>

#include "proto/wire/vector_message.h"

namespace telepalp::station {
namespace {

constexpr std::uint32_t kPeriod_ns = std::chrono::nanoseconds(kTickPeriod).count();
// A batch holds at most a tenth of a second, so that a viewer that plots ticks gets them promptly after a pause.
constexpr std::size_t kMostInBatch = 200;
constexpr std::int64_t kStatePeriod_ns = 10'000'000;

std::uint64_t stamp(SessionTime at) noexcept { return static_cast<std::uint64_t>(to_nanoseconds(at)); }

}  // namespace

TelemetryPublisher::TelemetryPublisher(TickRing& ticks, Publish publish, OnTick on_tick)
    : ticks_(ticks), publish_(std::move(publish)), on_tick_(std::move(on_tick)), totals_(kPeriod_ns) {
  batch_.reserve(kMostInBatch);
}

void TelemetryPublisher::drain(SessionTime now) {
  for (bool more = true; more;) {
    batch_.clear();
    loop::TickSample sample;
    while (batch_.size() < kMostInBatch && (more = ticks_.try_pop(sample))) {
      const RunTotals::Change change = totals_.add(sample);
      on_tick_(sample);
      if (change.phase_changed)
        publish_(
            wire::make_message(wire::kStationEvents, session_time(sample.stamp_ns), phase_event(sample, change.from)));
      batch_.push_back(sample);
    }
    if (batch_.empty()) return;
    last_ = batch_.back();
    has_ticked_ = true;
    publish_(wire::make_message(wire::kStationTicks, now, ticks_message(batch_, kPeriod_ns)));
    for (const loop::TickSample& tick : batch_)
      if (begins_state_period(tick)) publish_(wire::make_message(wire::kStationState, now, state_message(tick)));
    watch_heat(now);
  }
}

/// Periods are counted by the ticks' stamps, so that a late drain() leaves no gap between the states.
bool TelemetryPublisher::begins_state_period(const loop::TickSample& tick) {
  const std::int64_t period = tick.stamp_ns / kStatePeriod_ns;
  return std::exchange(state_period_, period) != period;
}

void TelemetryPublisher::watch_heat(SessionTime now) {
  constexpr float kWarnAhead_s = 4.0F;  // the hand feels the warning at the same time
  const bool near = last_.yields_in_s < kWarnAhead_s && last_.phase != 0;
  if (near && !heat_warned_)
    publish_event(
        now, msg::EVENT_KIND_HEAT,
        "the device's motors are warm: in at most 4 s the force begins to fall, slowly, to the force that the "
        "motors can hold without a time limit. fix: press less");
  // Warns again only after the force was low enough to be held without limit.
  if (near || std::isinf(last_.yields_in_s)) heat_warned_ = near;
}

void TelemetryPublisher::set_calibration(const Transform<HapticBase, HandTracker>& haptic_from_tracker) {
  const Eigen::Quaterniond turn(haptic_from_tracker.iso.linear());
  msg::RigidMotion& motion = haptic_from_tracker_.emplace();
  wire::set_vector(*motion.mutable_translation_m(), haptic_from_tracker.iso.translation());
  wire::set_vector(*motion.mutable_rotation(), turn.coeffs());
  motion.mutable_rotation()->set_w(turn.w());
}

void TelemetryPublisher::publish_event(SessionTime now, msg::EventKind kind, const std::string& text) {
  msg::StationEvent event;
  event.set_stamp_ns(stamp(now));
  event.set_surface_captured_ns(static_cast<std::uint64_t>(last_.surface_captured_ns));
  event.set_kind(kind);
  event.set_text(text);
  publish_(wire::make_message(wire::kStationEvents, now, event));
}

void TelemetryPublisher::publish_totals(SessionTime now, double clock_error_s, const HapticCounts& counts,
                                        std::uint64_t frames_dropped, bool realtime,
                                        const std::vector<msg::EffectCost>& bill) {
  totals_.set_missed(counts.deadlines_missed.load(std::memory_order_relaxed));
  totals_.set_frames_dropped(frames_dropped);
  totals_.set_telemetry_dropped(counts.ticks_dropped.load(std::memory_order_relaxed));
  msg::StationStats stats = totals_.message();
  stats.set_stamp_ns(stamp(now));
  stats.set_clock_error_s(clock_error_s);
  stats.set_realtime(realtime);
  if (idle_timer_) *stats.mutable_idle_timer() = *idle_timer_;
  if (haptic_from_tracker_) *stats.mutable_haptic_from_tracker() = *haptic_from_tracker_;
  stats.set_software(software_);
  for (const msg::EffectCost& cost : bill) *stats.add_bill() = cost;
  publish_(wire::make_message(wire::kStationStats, now, stats));
}

}  // namespace telepalp::station
