#include "haptic_station/control/parts/force_control.h"

#include <algorithm>

#include "haptic_station/control/safety/shortened.h"

namespace telepalp::control {

using Eigen::Vector3d;

Wrench<HapticBase> ForceControl::step(const ControlInput& in, bool touching, double bound_N, double lever_m,
                                      double dt_s) noexcept {
  contact_changed_ = touching != touching_;
  touching_ = touching;
  shown_ = in.contact;
  moved_m_ = in.device.m - last_device_.m - in.reindexed.v;
  last_device_ = in.device;
  coupling_.delayed_by(in.loop_delay_s);
  if (!touching) {
    ledger_.book(held_, measured_skin_N(Vector3d::Zero(), bound_N), moved_m_);
    return {};
  }
  effects_.place(in.placements);
  if (contact_changed_) sink_in_.begin(in.contact);
  sink_in_.step(in.contact, dt_s);
  shown_ = sink_in_.shown(in.contact);
  const effects::EffectInput felt = sink_in_.in_body_frame(in.device, in.device_velocity, shown_);
  last_felt_.m += sink_in_.sank_m() * in.contact.normal.v;
  if (contact_changed_) begin(felt, in, lever_m);
  return feel(felt, in, bound_N, lever_m, dt_s);
}

void ForceControl::begin(effects::EffectInput felt, const ControlInput& in, double lever_m) noexcept {
  tool_.begin(in.attitude);
  N_per_N_m_ = lever_m > 0.0 ? 1.0 / lever_m : 0.0;
  felt = tool_.turn(felt, in.attitude, effects_, false, 0.0);
  felt.turn.N_per_N_m = N_per_N_m_;
  effects_.begin(felt);
  coupling_.begin(felt.device);
  last_felt_ = felt.device;
  account_.begin();
  ledger_.begin();
  share_ = 1.0;
}

/// The wrench of the effects, whose springs are relaxed so that the device can give it. Sets in `exchange` the energy
/// that the effects took from the hand, the energy that they store, and the rotation of the tool that they see. The
/// coupling joins the points of tool and device, so a torque about the tool's point acts on the device as it is.
Wrench<HapticBase> ForceControl::ask_effects(const effects::EffectInput& felt, const ControlInput& in,
                                             Exchange& exchange, double bound_N, double dt_s) noexcept {
  coupling_.soften(felt);
  effects::EffectInput at = coupling_.engaged() ? coupling_.at_tool(felt) : felt;
  at = tool_.turn(at, in.attitude, effects_, exchange.lever_m > 0.0, dt_s);
  at.turn.N_per_N_m = N_per_N_m_;
  Wrench<HapticBase> asked = effects_.step(at, dt_s, bound_N, cost_clock_);
  if (coupling_.engaged()) {
    asked.force = coupling_.pull(asked.force);
    exchange.absorbed_J = coupling_.absorbed_J();
    exchange.stored_J = coupling_.energy_J();
  } else {
    coupling_.stand_by(asked.force);
  }
  exchange.absorbed_J += effects_.absorbed_J();
  exchange.stored_J += effects_.energy_J();
  exchange.turned = at.turn.turned;
  exchange.turning = in.turning;
  if (!tool_.shows_torque() || !effects_.feels_attitude()) exchange.lever_m = 0.0;
  return asked;
}

Wrench<HapticBase> ForceControl::feel(effects::EffectInput felt, const ControlInput& in, double bound_N, double lever_m,
                                      double dt_s) noexcept {
  felt.moved.v = felt.device.m - last_felt_.m;
  last_felt_ = felt.device;
  Exchange exchange;
  exchange.lever_m = N_per_N_m_ > 0.0 ? lever_m : 0.0;
  const Wrench<HapticBase> asked = ask_effects(felt, in, exchange, bound_N, dt_s);
  const Vector3d skin_velocity = felt.contact.surface_speed_m_per_s * felt.contact.normal.v;
  exchange.velocity = {felt.device_velocity.v - skin_velocity};
  exchange.moved = {felt.moved.v - skin_velocity * dt_s};
  ledger_.book(held_, measured_skin_N(asked.force.N, bound_N), moved_m_);
  ledger_.book_turn(held_, at_most(share_ * asked.torque.N_m, exchange.lever_m * bound_N), exchange.turned.v);
  exchange.hand_excess_J = ledger_.excess_J();
  exchange.device_velocity.v = in.device_velocity.v;
  return account_.step(asked, share_, exchange, bound_N, dt_s);
}

/// The force that the effects would give on the newest measured skin [N]: `asked_N`, plus the change of the first skin
/// effect's force between the displayed and the measured height. It is limited to `bound_N` and faded by the same share
/// as the contact.
Vector3d ForceControl::measured_skin_N(const Vector3d& asked_N, double bound_N) const noexcept {
  const effects::Skin* skin = effects_.skin();
  if (!shown_.valid || skin == nullptr) return asked_N;
  const Vector3d& normal = shown_.normal.v;
  const Vector3d displayed_m = touching_ ? skin->indentation().v : Vector3d::Zero().eval();
  const double deeper_m = shown_.coverage * shown_.measured_above_m - (touching_ ? 0.0 : shown_.distance_m);
  Vector3d measured_m = displayed_m - deeper_m * normal;
  measured_m -= std::max(0.0, measured_m.dot(normal)) * normal;  // the skin never pulls the hand
  const Vector3d change_N =
      touching_ ? effects_.change_with_skin_at(measured_m).N : effects::skin_force_N(skin->law(), measured_m);
  return at_most(share_ * (asked_N + change_N), bound_N);
}

void ForceControl::gave(const HeldForce& wanted, const Wrench<HapticBase>& given) noexcept {
  const Vector3d wanted_N = wanted.skin + wanted.drive + wanted.fade;
  held_ = wanted;
  held_.skin += given.force.N - wanted_N;
  held_.torque_N_m = given.torque.N_m;
  account_.limited(given, {.force = {wanted_N}, .torque = {wanted.torque_N_m}});
}

void ForceControl::release(bool release, double over_s, double dt_s) noexcept {
  if (!touching_) return;
  share_ = std::clamp(share_ + (release ? -dt_s : dt_s) / over_s, 0.0, 1.0);
}

}  // namespace telepalp::control
