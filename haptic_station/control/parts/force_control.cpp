#include "haptic_station/control/parts/force_control.h"

#include <algorithm>

#include "haptic_station/control/safety/shortened.h"

namespace telepalp::control {

using Eigen::Vector3d;

Vector3d ForceControl::step(const ControlInput& in, bool touching, double bound_N, double dt_s) noexcept {
  contact_changed_ = touching != touching_;
  touching_ = touching;
  shown_ = in.contact;
  moved_m_ = in.device.m - last_device_.m - in.reindexed.v;
  last_device_ = in.device;
  if (!touching) {
    ledger_.book(held_, measured_skin_N(Vector3d::Zero(), bound_N), moved_m_);
    return Vector3d::Zero();
  }
  effects_.place(in.placements);
  if (contact_changed_) sink_in_.begin(in.contact);
  sink_in_.step(in.contact, dt_s);
  shown_ = sink_in_.shown(in.contact);
  const effects::EffectInput felt = sink_in_.in_body_frame(in.device, in.device_velocity, shown_);
  last_felt_.m += sink_in_.sank_m() * in.contact.normal.v;
  if (contact_changed_) begin(felt);
  return feel(felt, in.device_velocity.v, bound_N, dt_s);
}

void ForceControl::begin(const effects::EffectInput& felt) noexcept {
  effects_.begin(felt);
  coupling_.begin(felt.device);
  last_felt_ = felt.device;
  account_.begin();
  ledger_.begin();
  share_ = 1.0;
}

/// The force of the effects, whose springs are relaxed so that the device can give it. Sets in `exchange` the energy
/// that the effects took from the hand and the energy that they store.
Force<HapticBase> ForceControl::ask_effects(const effects::EffectInput& felt, Exchange& exchange, double bound_N,
                                            double dt_s) noexcept {
  Force<HapticBase> force;
  if (coupling_.engaged()) {
    force = coupling_.pull(effects_.step(coupling_.at_tool(felt), dt_s, bound_N, cost_clock_));
    exchange.absorbed_J = coupling_.absorbed_J();
    exchange.stored_J = coupling_.energy_J();
  } else {
    force = effects_.step(felt, dt_s, bound_N, cost_clock_);
  }
  exchange.absorbed_J += effects_.absorbed_J();
  exchange.stored_J += effects_.energy_J();
  return force;
}

Vector3d ForceControl::feel(effects::EffectInput felt, const Vector3d& device_velocity, double bound_N,
                            double dt_s) noexcept {
  felt.moved.v = felt.device.m - last_felt_.m;
  last_felt_ = felt.device;
  Exchange exchange;
  const Vector3d asked_N = ask_effects(felt, exchange, bound_N, dt_s).N;
  const Vector3d skin_velocity = felt.contact.surface_speed_m_per_s * felt.contact.normal.v;
  exchange.velocity = {felt.device_velocity.v - skin_velocity};
  exchange.moved = {felt.moved.v - skin_velocity * dt_s};
  ledger_.book(held_, measured_skin_N(asked_N, bound_N), moved_m_);
  exchange.hand_excess_J = ledger_.excess_J();
  exchange.device_velocity.v = device_velocity;
  return account_.step(asked_N, share_, exchange, bound_N, dt_s);
}

/// The force that the effects would give on the newest measured skin [N]: `asked_N`, plus the change of the first skin
/// effect's force between the displayed and the measured height. It is limited to `bound_N` and faded by the same share
/// as the contact.
Vector3d ForceControl::measured_skin_N(const Vector3d& asked_N, double bound_N) const noexcept {
  const effects::Skin* skin = effects_.skin();
  if (!shown_.valid || skin == nullptr) return asked_N;
  const Vector3d& normal = shown_.normal.v;
  const Vector3d displayed_m = touching_ ? skin->indentation().v : Vector3d::Zero().eval();
  const double deeper_m = shown_.support * shown_.measured_above_m - (touching_ ? 0.0 : shown_.distance_m);
  Vector3d measured_m = displayed_m - deeper_m * normal;
  measured_m -= std::max(0.0, measured_m.dot(normal)) * normal;  // the skin never pulls the hand
  const Vector3d change_N =
      touching_ ? effects_.change_with_skin_at(measured_m).N : effects::skin_force_N(skin->law(), measured_m);
  return at_most(share_ * (asked_N + change_N), bound_N);
}

void ForceControl::gave(const HeldForce& wanted, const Vector3d& given_N) noexcept {
  const Vector3d wanted_N = wanted.skin + wanted.drive + wanted.fade;
  held_ = wanted;
  held_.skin += given_N - wanted_N;
  account_.limited(given_N, wanted_N);
}

void ForceControl::release(bool release, double over_s, double dt_s) noexcept {
  if (!touching_) return;
  share_ = std::clamp(share_ + (release ? -dt_s : dt_s) / over_s, 0.0, 1.0);
}

}  // namespace telepalp::control
