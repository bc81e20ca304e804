#include "haptic_station/loop/haptic_loop.h"

#include <limits>

#include "haptic_station/loop/packed.h"
#include "haptic_station/loop/time_line.h"

namespace telepalp::loop {

void HapticLoop::adopt(const TouchableSurface& surface, SessionTime now) noexcept {
  if (!surface.snapshot) return;
  camera_.haptic_from_camera = surface.haptic_from_camera;
  camera_.camera_from_haptic = surface.haptic_from_camera.inverse();
  camera_.turn = Eigen::Quaterniond(camera_.camera_from_haptic.iso.linear());
  touch_.adopt(*surface.snapshot, now);
  body_.adopt(*surface.snapshot, surface.haptic_from_camera);
  surface_captured_ = surface.snapshot->captured;
  has_surface_ = true;
}

void HapticLoop::hand_sampled(const ports::HandSample& sample) noexcept {
  // A sample from the future is dropped. If it were used, all later samples would seem older than it.
  if (ticked_ && sample.at > last_.at + kSameSession) return;
  const tracking::Taken taken = hand_.update(sample.at, sample.hand);
  if (taken != tracking::Taken::Used && taken != tracking::Taken::Restarted) return;
  newest_hand_ = {.at = sample.hand, .sampled = sample.at, .wait_at_m = sample.wait_at_m};
  if (sample.attitude) (void)attitude_.update(sample.at, *sample.attitude);
}

ports::SurfaceContact HapticLoop::contact_of(const surface::TouchSample& touch) const noexcept {
  return {.proxy = camera_.haptic_from_camera * touch.proxy,
          .normal = camera_.haptic_from_camera * Vector<DepthCamera>{touch.normal},
          .distance_m = touch.distance_m,
          .in_body = touch.in_body,
          .valid = touch.valid,
          .surface_speed_m_per_s = touch.surface_velocity_m_per_s,
          .coverage = touch.coverage,
          .measured_above_m = touch.newest_above_m,
          .measured_speed_m_per_s = touch.newest_velocity_m_per_s,
          .anchor_seen = touch.in_body && !anchor_lost_,
          .anchor_velocity = camera_.haptic_from_camera * Vector<DepthCamera>{touch.anchor_velocity_m_per_s},
          .age_s = has_surface_ ? touch.age_s : std::numeric_limits<double>::infinity()};
}

void HapticLoop::begin_new_time_line() noexcept {
  touch_.release();
  body_.release();
  hand_.forget();
  attitude_.forget();
  has_surface_ = false;
}

ObjectPlacements HapticLoop::objects() const noexcept {
  ObjectPlacements objects = body_.objects();
  const auto bill = controller_.effects().bill();
  for (std::size_t i = 0; i < bill.size(); ++i) objects[i].name = bill[i].name;
  return objects;
}

TickOut HapticLoop::tick(const TickIn& given) noexcept {
  const SessionTime now = given.now;
  const double dt_s = given.dt_s;
  if (given.surface != nullptr) adopt(*given.surface, now);
  if (given.hand) hand_sampled(*given.hand);
  if (begins_new_time_line(now, last_.at)) begin_new_time_line();
  last_.at = now;
  ticked_ = true;
  // Sense.
  const GatedReading gated = device_gate_.step(given.reading, dt_s);
  loop_delay_.add(given.reading);
  const Indexed indexed = indexing_.step(gated.at, dt_s);
  const Point<HapticBase> device_at = in_patient_frame(gated.at);
  const surface::TouchSample touch =
      touch_.step(camera_.camera_from_haptic * device_at, now, dt_s, controller_.touching());
  anchor_lost_ = touch.in_body && (anchor_lost_ || !indexed.interacts);
  tracking::HandPrediction hand = hand_.predict(now);
  hand.at = in_patient_frame(hand.at);
  const control::ControlInput in{.device = device_at,
                                 .device_velocity = gated.velocity,
                                 .device_age_s = gated.unreadable_s > 0.0 ? 0.0 : given.reading.age_s,
                                 .device_implausible_s = gated.implausible_s,
                                 .device_unreadable_s = gated.unreadable_s,
                                 .hand = hand.at,
                                 .hand_velocity = hand.velocity,
                                 .hand_valid = hand.valid,
                                 .hand_age_s = hand.age_s,
                                 .hand_implausible_s = hand.implausible_s,
                                 .contact = contact_of(touch),
                                 .placements = body_.step(touch, dt_s),
                                 .interacts = indexed.interacts,
                                 .recall = indexed.recall,
                                 .reindexed = indexed.moved,
                                 .wait_at_m = newest_hand_.wait_at_m,
                                 .attitude = attitude_gate_.step(given.reading, dt_s),
                                 .turning = attitude_gate_.turning(given.reading),
                                 .power = given.reading.power,
                                 .loop_delay_s = loop_delay_.p99_s().value_or(0.0),
                                 .rearm = given.rearm};
  last_.touch = touch;
  last_.hand = hand;
  // Decide.
  const control::ControlOutput out = controller_.step(in, dt_s);
  last_.out = out;
  // Act: the caller applies the force.
  return {
      .force = out.force, .torque = out.torque, .contact = in.contact, .control = out, .sample = sample_of(in, out)};
}

Compensation HapticLoop::compensation() const noexcept {
  Compensation compensation =
      compensation_of(last_.hand, in_patient_frame(newest_hand_.at), last_.touch, touch_.displaced(), last_.out);
  compensation.surface_captured_ns = has_surface_ ? to_nanoseconds(surface_captured_) : 0;
  compensation.device_jumps = device_gate_.jumps() + attitude_gate_.jumps();
  compensation.hand_jumps = hand_.refused();
  compensation.loop_delay_s = loop_delay_.p99_s();
  compensation.stiffest_shown_N_per_m = controller_.coupling().limit_N_per_m();
  compensation.effects_N_per_m = controller_.coupling().effects_N_per_m();
  compensation.objects = objects();
  return compensation;
}

TickSample HapticLoop::sample_of(const control::ControlInput& in, const control::ControlOutput& out) const noexcept {
  TickSample sample;
  sample.phase = static_cast<std::uint8_t>(out.phase);
  sample.fault = static_cast<std::uint8_t>(out.fault);
  sample.fault_stands = static_cast<std::uint8_t>(out.fault_stands);
  sample.in_body = in.contact.in_body;
  sample.contact_unknown = !in.contact.valid;
  sample.limited = out.limited;
  sample.object_unseen = body_.unseen();
  sample.object_slide_unseen = body_.slide_unseen();
  sample.indexing = !in.interacts;
  sample.workspace_shift = packed(indexing_.now().shift.v);
  sample.hand = packed(in.hand.m);
  sample.device = packed(in.device.m);
  sample.proxy = packed(in.contact.proxy.m);
  sample.normal = packed(in.contact.normal.v);
  sample.force = packed_towards_zero(out.force.N);
  sample.displayed_hand_camera = packed((camera_.camera_from_haptic * out.displayed_hand).m);
  if (const auto attitude = attitude_.predict(last_.at)) sample.hand_attitude_camera = packed(camera_.turn * *attitude);
  sample.proxy_camera = packed((camera_.camera_from_haptic * in.contact.proxy).m);
  sample.normal_camera = packed((camera_.camera_from_haptic * in.contact.normal).v);
  sample.device_camera = packed((camera_.camera_from_haptic * in.device).m);
  sample.force_camera = packed_towards_zero((camera_.camera_from_haptic * out.force).N);
  sample.gives_torque = in.power.most_N_m > 0.0;
  sample.torque = packed_towards_zero(out.torque.N_m);
  sample.torque_camera = packed_towards_zero(camera_.camera_from_haptic.iso.linear() * out.torque.N_m);
  if (in.attitude) sample.tool_attitude_camera = packed(camera_.turn * *in.attitude);
  sample.indentation_m = static_cast<float>(out.indentation.v.norm());
  sample.distance_m = static_cast<float>(in.contact.distance_m);
  sample.passivity_J = static_cast<float>(out.passivity_J);
  sample.hand_excess_J = static_cast<float>(out.hand_excess_J);
  sample.unmodelled = static_cast<float>(last_.touch.unmodelled);
  sample.yields_in_s = static_cast<float>(out.yields_in_s);
  sample.device_age_s = static_cast<float>(in.device_age_s + in.device_unreadable_s);
  sample.hand_age_s = static_cast<float>(in.hand_age_s);
  sample.surface_age_s = static_cast<float>(in.contact.age_s);
  sample.surface_captured_ns = has_surface_ ? to_nanoseconds(surface_captured_) : 0;
  sample.hand_sampled_ns = to_nanoseconds(newest_hand_.sampled);
  return sample;
}

}  // namespace telepalp::loop
