#include "haptic_station/control/encountered_controller.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptic_station/control/parts/input_check.h"

namespace telepalp::control {

ControlOutput EncounteredController::step(const ControlInput& given, double dt_given_s) noexcept {
  const double dt_s = std::isfinite(dt_given_s) ? std::clamp(dt_given_s, 0.0, 0.01) : 0.0;
  // Sense.
  const FaultCause stands = standing_fault(given, force_control_.touching(), settings_.ages);
  const std::optional<ControlInput> blank =
      stands == FaultCause::NotFinite ? std::optional(blank_input(given, target_)) : std::nullopt;
  const ControlInput& in = blank ? *blank : given;
  limiter_.device_gives(in.power);
  watch_rise(in);
  plane_.move(in.device, in.contact, in.wait_at_m, dt_s);
  force_control_.release(hand_is_lost(in, settings_.ages.tracker_in_contact_s), settings_.transitions.contact_release_s,
                         dt_s);
  // Decide.
  const std::optional<Event> event = phases_.step(seen_of(in, stands), stands, dt_s);
  if (event) enter_phase(*event, in);
  // Act.
  HeldForce wanted = phase_force(in, dt_s);
  // Position control goes on with the lift's force, so where Out body begins, nothing breaks.
  const bool breaks = (phases_.outer_change() && phases_.phase() != Phase::OutBody) || force_control_.contact_changed();
  (void)fade_.step(wanted.skin + wanted.drive, breaks, fade_rate_N_per_s(), dt_s);
  wanted.fade = fade_.fading_N();
  const Wrench<HapticBase> wrench = limited(wanted, dt_s);

  ControlOutput out = output();
  out.event = event.value_or(Event::Rearm);
  out.force = wrench.force;
  out.torque = wrench.torque;
  out.fault_stands = stands;
  out.displayed_hand = displayed_hand_.step(in, force_control_.shown(), is_inside(phases_.phase()), dt_s);
  return out;
}

/// The part of the input that the phases depend on. `stands`: the cause that would fault this tick.
Seen EncounteredController::seen_of(const ControlInput& in, FaultCause stands) const noexcept {
  const double hand_m = in.hand.m.y();
  const double device_m = in.device.m.y();
  const double risen_m = settings_.transitions.hand_rose_m;
  Seen seen;
  seen.fault_stands = stands != FaultCause::None;
  seen.fault_latched = limiter_.faulted();
  seen.rearm = in.rearm;
  seen.inputs_stale = inputs_are_stale(in);
  seen.in_body = in.contact.valid && in.contact.in_body && !rises_unfelt_;
  seen.outside = in.contact.valid && !in.contact.in_body;
  seen.below_plane = device_m < plane_.height_m();
  seen.at_plane = device_m >= plane_.target_height_m();
  seen.hand_rose = hand_m > plane_.height_m() + risen_m && hand_m > device_m + risen_m;
  seen.touch = force_control_.effects().touch();
  return seen;
}

void EncounteredController::enter_phase(Event event, const ControlInput& in) noexcept {
  if (event == Event::Rearm) limiter_.rearm();
  if (phases_.phase() == Phase::OutBody) position_control_.begin(in, plane_.target_height_m(), lift_.force_N());
}

/// A browser's hand that hovers presses nothing. So an end-effector that came below the skin while no force held it is
/// lifted out of the body without a contact.
void EncounteredController::watch_rise(const ControlInput& in) noexcept {
  const bool outside = in.contact.valid && !in.contact.in_body;
  const bool let_go = has_let_go(phases_.phase());
  rises_unfelt_ = in.wait_at_m && (let_go || (rises_unfelt_ && !outside));
}

/// True when the skin gives force: in the phases inside the body, and in Body to plane while the device is in the body;
/// never while workspace indexing moves the body past the device (`interacts` is false).
bool EncounteredController::feels_skin(const ControlInput& in) const noexcept {
  const bool may_feel = is_inside(phases_.phase()) || phases_.phase() == Phase::BodyToPlane;
  return may_feel && !rises_unfelt_ && in.interacts && in.contact.valid && in.contact.in_body;
}

/// The skin's force depends only on the device and the surface. Therefore a lost hand does not end the contact at once:
/// force control fades the contact out, and only then the input counts as stale.
bool EncounteredController::inputs_are_stale(const ControlInput& in) const noexcept {
  const bool holds = force_control_.touching() && !force_control_.released();
  return device_is_unreadable(in, settings_.ages) || surface_is_stale(in, settings_.ages) ||
         (!holds && hand_is_lost(in, settings_.ages.tracker_s));
}

/// Upper bound of the force of the displayed skin and of the measured skin now [N]. In Released and Faulted, it is the
/// magnitude of the force that the device still gives. With a larger bound, the hand ledger would compare the work of
/// the measured skin with that of a device that gives no force, and report an excess for a hand that presses on.
double EncounteredController::owed_N() const noexcept {
  return has_let_go(phases_.phase()) ? force_control_.given_N() : limiter_.bound_N();
}

/// The force of the phase: force control, the lift or position control, and the recall of workspace indexing. Inside
/// the skin there is no lift, because the skin pushes outwards.
HeldForce EncounteredController::phase_force(const ControlInput& in, double dt_s) noexcept {
  target_ = in.device;
  HeldForce force;
  const Wrench<HapticBase> felt = force_control_.step(in, feels_skin(in), owed_N(), limiter_.lever_m(), dt_s);
  force.skin = felt.force.N;
  force.torque_N_m = felt.torque.N_m;
  if (force_control_.touching()) force.skin += heat_warning_.step(force.skin, limiter_, dt_s);
  if (phases_.phase() == Phase::BodyToPlane && !force_control_.touching())
    force.drive = lift_.step(in, plane_.target_height_m(), dt_s);
  else
    lift_.rest();
  if (phases_.phase() == Phase::OutBody) {
    force.drive = position_control_.step(in, plane_.target_height_m(), dt_s);
    target_ = position_control_.target();
  }
  if (!has_let_go(phases_.phase())) force.drive += in.recall.N;
  return force;
}

/// A fault fades any force to zero within 30 ms. A release, after which the contact resumes by itself, takes 52 ms, so
/// that the force changes by less than 0.1 N a tick, also while the skin's own force changes.
double EncounteredController::fade_rate_N_per_s() const noexcept {
  constexpr double kFaultWithin_s = 0.03;
  constexpr double kReleaseWithin_s = 0.052;
  if (phases_.phase() == Phase::Faulted) return settings_.limits.peak_N / kFaultWithin_s;
  if (phases_.phase() == Phase::Released) return settings_.limits.peak_N / kReleaseWithin_s;
  return settings_.transitions.force_fade_N_per_s;
}

Wrench<HapticBase> EncounteredController::limited(const HeldForce& wanted, double dt_s) noexcept {
  const Wrench<HapticBase> given =
      limiter_.limit({.force = {wanted.skin + wanted.drive + wanted.fade}, .torque = {wanted.torque_N_m}}, dt_s);
  force_control_.gave(wanted, given);
  return given;
}

/// Collects the output of the parts after a tick.
ControlOutput EncounteredController::output() const noexcept {
  ControlOutput out;
  out.phase = phases_.phase();
  out.previous = phases_.previous();
  out.target = target_;
  out.indentation = force_control_.indentation();
  out.plane_height_m = plane_.height_m();
  out.passivity_J = force_control_.passivity().balance_J();
  out.hand_excess_J = force_control_.hand_ledger().excess_J();
  out.drive_J = force_control_.hand_ledger().drive_J();
  out.yields_in_s = force_control_.touching() ? heat_warning_.yields_in_s() : std::numeric_limits<double>::infinity();
  out.damping = force_control_.damping();
  out.surface_speed_m_per_s = force_control_.shown().surface_speed_m_per_s;
  out.limited = limiter_.limited() || force_control_.withholds();
  out.fault = phases_.fault();
  return out;
}

}  // namespace telepalp::control
