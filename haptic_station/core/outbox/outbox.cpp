#include "haptic_station/core/outbox/outbox.h"

#include <cmath>
#include <utility>

#include "haptic_station/core/outbox/tick_messages.h"
#include "haptic_station/core/stamp.h"
#include "proto/wire/topics.h"
#include "proto/wire/vector_message.h"

namespace telepalp::core {
namespace {

constexpr std::int64_t kStatePeriod_ns = 10'000'000;

}  // namespace

Outbox::Messages Outbox::ticks(std::span<const loop::TickSample> batch, SessionTime now) {
  Messages messages;
  if (batch.empty()) return messages;
  for (const loop::TickSample& tick : batch)
    if (const RunTotals::Change change = totals_.add(tick); change.phase_changed)
      messages.push_back(
          wire::make_message(wire::kStationEvents, session_time(tick.stamp_ns), phase_event(tick, change.from)));
  last_ = batch.back();
  for (const auto run : unbroken_runs(batch))
    messages.push_back(wire::make_message(wire::kStationTicks, now, ticks_message(run)));
  for (const loop::TickSample& tick : batch)
    if (begins_state_period(tick))
      messages.push_back(wire::make_message(wire::kStationState, now, state_message(tick)));
  if (heat_is_near(*last_))
    messages.push_back(event(msg::EVENT_KIND_HEAT,
                             "the device's motors are warm: in at most 4 s the force begins to fall, slowly, to the "
                             "force that the motors can hold without a time limit. fix: press less",
                             now));
  return messages;
}

/// Periods are counted by the ticks' stamps, so that a late call leaves no gap between the states.
bool Outbox::begins_state_period(const loop::TickSample& tick) noexcept {
  const std::int64_t period = tick.stamp_ns / kStatePeriod_ns;
  return std::exchange(state_period_, period) != period;
}

bool Outbox::heat_is_near(const loop::TickSample& tick) noexcept {
  constexpr float kWarnAhead_s = 4.0F;  // the hand feels the warning at the same time
  const bool near = tick.yields_in_s < kWarnAhead_s && tick.phase != 0;
  const bool warns = near && !heat_warned_;
  // Warns again only after the force was low enough to be held without limit.
  if (near || std::isinf(tick.yields_in_s)) heat_warned_ = near;
  return warns;
}

wire::Message Outbox::compensation(const loop::Compensation& compensation, SessionTime now) const {
  msg::StationCompensation message = compensation_message(compensation);
  message.set_clock_error_s(facts_.clock_error_s);
  return wire::make_message(wire::kStationCompensation, now, message);
}

wire::Message Outbox::surface(msg::SurfaceReport report, SessionTime now) const {
  report.set_clock_error_s(facts_.clock_error_s);
  return wire::make_message(wire::kStationSurface, now, report);
}

wire::Message Outbox::event(msg::EventKind kind, const std::string& text, SessionTime now) const {
  msg::StationEvent event;
  event.set_stamp_ns(stamp(now));
  event.set_surface_captured_ns(last_ ? static_cast<std::uint64_t>(last_->surface_captured_ns) : 0);
  event.set_kind(kind);
  event.set_text(text);
  return wire::make_message(wire::kStationEvents, now, event);
}

wire::Message Outbox::fault(const loop::TickSample& first, SessionTime now) {
  return wire::make_message(wire::kStationEvents, now, fault_event(first));
}

wire::Message Outbox::ultrasound(const msg::UltrasoundImage& image, SessionTime now) {
  return wire::make_message(wire::kStationUltrasound, now, image);
}

wire::Message Outbox::inside(const msg::InnerStructures& structures, SessionTime now) {
  return wire::make_message(wire::kStationInside, now, structures);
}

wire::Message Outbox::totals(const Counts& counts, SessionTime now) const {
  msg::StationStats stats = totals_.message();
  stats.set_deadlines_missed(counts.deadlines_missed);
  stats.set_frames_dropped(counts.frames_dropped);
  stats.set_telemetry_dropped(counts.ticks_dropped);
  stats.set_stamp_ns(stamp(now));
  stats.set_clock_error_s(facts_.clock_error_s);
  stats.set_realtime(facts_.realtime);
  if (facts_.idle_timer) *stats.mutable_idle_timer() = *facts_.idle_timer;
  if (facts_.haptic_from_tracker) *stats.mutable_haptic_from_tracker() = *facts_.haptic_from_tracker;
  stats.set_software(facts_.software);
  for (const msg::EffectCost& cost : facts_.costs) *stats.add_bill() = cost;
  return wire::make_message(wire::kStationStats, now, stats);
}

msg::RigidMotion motion_message(const Transform<HapticBase, HandTracker>& haptic_from_tracker) {
  const Eigen::Quaterniond turn(haptic_from_tracker.iso.linear());
  msg::RigidMotion motion;
  wire::set_vector(*motion.mutable_translation_m(), haptic_from_tracker.iso.translation());
  wire::set_vector(*motion.mutable_rotation(), turn.coeffs());
  motion.mutable_rotation()->set_w(turn.w());
  return motion;
}

}  // namespace telepalp::core
