#include "haptic_station/core/outbox/tick_messages.h"

#include <algorithm>
#include <cstdlib>

#include "haptic_station/control/phases/phase.h"
#include "haptic_station/loop/tick.h"
#include "proto/wire/vector_message.h"
#include "proto/words/demand.h"
#include "proto/words/phase_names.h"

namespace telepalp::core {
namespace {

using Triple = std::array<float, 3>;

bool is_known(const std::array<float, 4>& attitude) noexcept {
  return std::ranges::any_of(attitude, [](float part) { return part != 0.0F; });
}

void set_rotation(msg::Rotation& rotation, const std::array<float, 4>& xyzw) {
  rotation.set_x(xyzw[0]);
  rotation.set_y(xyzw[1]);
  rotation.set_z(xyzw[2]);
  rotation.set_w(xyzw[3]);
}

msg::Phase phase_of(const loop::TickSample& sample) noexcept { return static_cast<msg::Phase>(sample.phase); }

}  // namespace

msg::StationState state_message(const loop::TickSample& sample) {
  msg::StationState state;
  state.set_stamp_ns(static_cast<std::uint64_t>(sample.stamp_ns));
  state.set_surface_captured_ns(static_cast<std::uint64_t>(sample.surface_captured_ns));
  state.set_hand_sampled_ns(static_cast<std::uint64_t>(sample.hand_sampled_ns));
  state.set_phase(phase_of(sample));
  wire::set_vector(*state.mutable_hand(), sample.hand);
  wire::set_vector(*state.mutable_device(), sample.device);
  wire::set_vector(*state.mutable_proxy(), sample.proxy);
  wire::set_vector(*state.mutable_normal(), sample.normal);
  wire::set_vector(*state.mutable_force_n(), sample.force);
  wire::set_vector(*state.mutable_displayed_hand_camera(), sample.displayed_hand_camera);
  wire::set_vector(*state.mutable_proxy_camera(), sample.proxy_camera);
  wire::set_vector(*state.mutable_normal_camera(), sample.normal_camera);
  wire::set_vector(*state.mutable_device_camera(), sample.device_camera);
  wire::set_vector(*state.mutable_force_camera_n(), sample.force_camera);
  if (is_known(sample.hand_attitude_camera))
    set_rotation(*state.mutable_hand_attitude_camera(), sample.hand_attitude_camera);
  if (is_known(sample.tool_attitude_camera))
    set_rotation(*state.mutable_tool_attitude_camera(), sample.tool_attitude_camera);
  if (sample.gives_torque) {
    wire::set_vector(*state.mutable_torque_n_m(), sample.torque);
    wire::set_vector(*state.mutable_torque_camera_n_m(), sample.torque_camera);
  }
  state.set_distance_m(sample.distance_m);
  state.set_indentation_m(sample.indentation_m);
  state.set_in_body(sample.in_body);
  state.set_surface_stale(sample.contact_unknown);
  state.set_limited(sample.limited);
  state.set_passivity_j(sample.passivity_J);
  state.set_hand_excess_j(sample.hand_excess_J);
  state.set_yields_in_s(sample.yields_in_s);
  state.set_unmodelled(sample.unmodelled);
  state.set_object_unseen(sample.object_unseen);
  state.set_object_slide_unseen(sample.object_slide_unseen);
  if (sample.workspace_shift != Triple{}) wire::set_vector(*state.mutable_workspace_shift(), sample.workspace_shift);
  state.set_indexing(sample.indexing);
  return state;
}

msg::StationCompensation compensation_message(const loop::Compensation& compensation) {
  msg::StationCompensation out;
  out.set_stamp_ns(static_cast<std::uint64_t>(compensation.stamp_ns));
  out.set_surface_captured_ns(static_cast<std::uint64_t>(compensation.surface_captured_ns));
  out.set_hand_age_s(compensation.hand_age_s);
  out.set_hand_carried_m(compensation.hand_carried_m);
  out.set_hand_sigma_m(compensation.hand_sigma_m);
  out.set_surface_age_s(compensation.surface_age_s);
  out.set_surface_carried_m(compensation.surface_carried_m);
  out.set_surface_sigma_m(compensation.surface_sigma_m);
  out.set_slewed_m(compensation.slewed_m);
  out.set_support(compensation.coverage);
  out.set_shown_offset_m(compensation.shown_offset_m);
  out.set_damping_n(compensation.damping_N);
  out.set_hand_excess_j(compensation.hand_excess_J);
  out.set_drive_j(compensation.drive_J);
  out.set_unmodelled(compensation.unmodelled);
  out.set_device_jumps(compensation.device_jumps);
  out.set_hand_jumps(compensation.hand_jumps);
  if (compensation.loop_delay_s) out.set_loop_delay_s(*compensation.loop_delay_s);
  out.set_stiffness_limit_n_per_m(compensation.stiffest_shown_N_per_m);
  out.set_effects_n_per_m(compensation.effects_N_per_m);
  for (std::size_t i = 0; i < compensation.objects.size(); ++i) {
    const loop::ObjectPlacement& placed = compensation.objects[i];
    if (!placed.watched) continue;
    msg::ObjectPlacement& object = *out.add_objects();
    object.set_name(placed.name);
    object.set_effect(static_cast<std::uint32_t>(i));
    wire::set_vector(*object.mutable_moved(), placed.moved);
    object.set_sigma_normal_m(placed.sigma_normal_m);
    object.set_sigma_slide_m(placed.sigma_slide_m);
    object.set_unseen(placed.unseen);
    object.set_slide_unseen(placed.slide_unseen);
  }
  return out;
}

msg::StationEvent phase_event(const loop::TickSample& sample, std::uint8_t from) {
  msg::StationEvent event;
  event.set_stamp_ns(static_cast<std::uint64_t>(sample.stamp_ns));
  event.set_surface_captured_ns(static_cast<std::uint64_t>(sample.surface_captured_ns));
  event.set_kind(msg::EVENT_KIND_PHASE);
  event.set_from(static_cast<msg::Phase>(from));
  event.set_to(phase_of(sample));
  event.set_text(change_in_words(from, sample.phase));
  return event;
}

msg::StationEvent fault_event(const loop::TickSample& first) {
  msg::StationEvent event;
  event.set_stamp_ns(static_cast<std::uint64_t>(first.stamp_ns));
  event.set_surface_captured_ns(static_cast<std::uint64_t>(first.surface_captured_ns));
  event.set_kind(msg::EVENT_KIND_FAULT);
  event.set_text(control::name(static_cast<control::FaultCause>(first.fault)));
  return event;
}

std::vector<std::span<const loop::TickSample>> unbroken_runs(std::span<const loop::TickSample> samples) {
  constexpr std::int64_t kPeriod_ns = Nanoseconds(loop::kTickPeriod).count();
  // Half a period, because the session clock is steered and so a period of it is not exactly one of the timer.
  const auto follows = [](const loop::TickSample& before, const loop::TickSample& tick) {
    return tick.tick == before.tick + 1 && std::abs(tick.stamp_ns - before.stamp_ns - kPeriod_ns) <= kPeriod_ns / 2;
  };
  std::vector<std::span<const loop::TickSample>> runs;
  while (!samples.empty()) {
    std::size_t size = 1;
    while (size < samples.size() && follows(samples[size - 1], samples[size])) ++size;
    runs.push_back(samples.first(size));
    samples = samples.subspan(size);
  }
  return runs;
}

msg::StationTicks ticks_message(std::span<const loop::TickSample> samples) {
  demand(!samples.empty(), "a batch holds at least one tick");
  msg::StationTicks ticks;
  ticks.set_first_tick_ns(static_cast<std::uint64_t>(samples.front().stamp_ns));
  ticks.set_first_tick(samples.front().tick);
  ticks.set_period_ns(static_cast<std::uint32_t>(Nanoseconds(loop::kTickPeriod).count()));
  ticks.set_surface_captured_ns(static_cast<std::uint64_t>(samples.front().surface_captured_ns));
  const bool turns = std::ranges::any_of(samples, [](const auto& sample) { return sample.torque != Triple{}; });
  for (const loop::TickSample& sample : samples) {
    if (turns) {
      ticks.add_torque_x(sample.torque[0]);
      ticks.add_torque_y(sample.torque[1]);
      ticks.add_torque_z(sample.torque[2]);
    }
    ticks.add_late_ns(sample.late_ns);
    ticks.add_work_us(sample.work_us);
    ticks.add_phase(phase_of(sample));
    ticks.add_hand_x(sample.hand[0]);
    ticks.add_hand_y(sample.hand[1]);
    ticks.add_hand_z(sample.hand[2]);
    ticks.add_device_x(sample.device[0]);
    ticks.add_device_y(sample.device[1]);
    ticks.add_device_z(sample.device[2]);
    ticks.add_proxy_x(sample.proxy[0]);
    ticks.add_proxy_y(sample.proxy[1]);
    ticks.add_proxy_z(sample.proxy[2]);
    ticks.add_force_x(sample.force[0]);
    ticks.add_force_y(sample.force[1]);
    ticks.add_force_z(sample.force[2]);
    ticks.add_indentation_m(sample.indentation_m);
    ticks.add_distance_m(sample.distance_m);
    ticks.add_device_age_s(sample.device_age_s);
    ticks.add_hand_age_s(sample.hand_age_s);
    ticks.add_surface_age_s(sample.surface_age_s);
  }
  return ticks;
}

}  // namespace telepalp::core
