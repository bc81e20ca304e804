#include "haptic_station/control/parts/force_control.h"

namespace telepalp::control {

Eigen::Vector3d ForceControl::step(const ControlInput& in, bool touching, double bound_N, double dt_s) noexcept {
  contact_changed_ = touching != touching_;
  touching_ = touching;
  shown_ = in.contact;
  if (!touching) return Eigen::Vector3d::Zero();
  if (contact_changed_) sink_in_.begin(-in.contact.distance_m);
  sink_in_.step(dt_s);
  shown_ = sink_in_.shown(in.contact);
  const effects::EffectInput felt = sink_in_.in_body_frame(in.device, in.device_velocity, shown_);
  if (contact_changed_) begin(felt);
  return feel(felt, bound_N, dt_s);
}

void ForceControl::begin(const effects::EffectInput& felt) noexcept {
  effects_.begin(felt);
  coupling_.begin(felt.device);
  last_felt_ = felt.device;
  account_.begin();
}

Eigen::Vector3d ForceControl::feel(effects::EffectInput felt, double bound_N, double dt_s) noexcept {
  felt.moved.v = felt.device.m - last_felt_.m;
  last_felt_ = felt.device;
  Force<HapticBase> force;
  Exchange exchange;
  if (coupling_.engaged()) {
    force = coupling_.pull(effects_.step(coupling_.at_tool(felt), dt_s, cost_clock_));
    exchange.absorbed_J = coupling_.absorbed_J();
    exchange.stored_J = coupling_.energy_J();
  } else {
    force = effects_.step(felt, dt_s, cost_clock_);
  }
  exchange.absorbed_J += effects_.absorbed_J();
  exchange.stored_J += effects_.energy_J();
  const Eigen::Vector3d skin_velocity = felt.contact.surface_speed_m_per_s * felt.contact.normal.v;
  exchange.velocity = {felt.device_velocity.v - skin_velocity};
  exchange.moved = {felt.moved.v - skin_velocity * dt_s};
  return account_.step(force.N, exchange, bound_N, dt_s);
}

void ForceControl::limited(const Eigen::Vector3d& given_N, const Eigen::Vector3d& wanted_N) noexcept {
  account_.limited(given_N, wanted_N);
}

}  // namespace telepalp::control
