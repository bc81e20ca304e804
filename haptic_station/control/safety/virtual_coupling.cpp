#include "haptic_station/control/safety/virtual_coupling.h"

#include <algorithm>

namespace telepalp::control {
namespace {

constexpr double kSoftensBy = 0.003;  // greatest change of the force in a tick, as a share of the force: 0.03 N at 10 N

}  // namespace

double stiffest_shown_N_per_m(const CouplingSettings& settings) noexcept {
  return settings.margin * settings.device_damping_N_s_per_m / (0.5 * settings.tick_s + settings.loop_delay_s);
}

VirtualCoupling::VirtualCoupling(const CouplingSettings& settings, double effects_N_per_m) noexcept
    : settings_(settings),
      effects_N_per_m_(effects_N_per_m),
      stiffness_N_per_m_(stiffest_shown_N_per_m(settings)),
      engaged_(settings.enabled && effects_N_per_m > stiffness_N_per_m_) {}

void VirtualCoupling::begin(const Point<HapticBase>& device) noexcept {
  stiffness_N_per_m_ = limit_N_per_m();
  engaged_ = settings_.enabled && effects_N_per_m_ > stiffness_N_per_m_;
  tool_ = device;
  gap_m_.setZero();
  on_tool_N_.setZero();
  on_device_N_.setZero();
}

/// Through a spring of stiffness k, the hand feels the share k / (k + effects) of the force that it would feel on the
/// effects alone. This share, and so the force, falls by at most kSoftensBy in a tick, whatever k is.
void VirtualCoupling::soften(const effects::EffectInput& at_device) noexcept {
  softened_J_ = 0.0;
  const double limit = limit_N_per_m();
  if (!settings_.enabled || limit >= (engaged_ ? stiffness_N_per_m_ : effects_N_per_m_)) return;
  double share = 1.0;
  if (engaged_) {
    share = stiffness_N_per_m_ / (stiffness_N_per_m_ + effects_N_per_m_);
  } else {  // without a spring, the tool was at the device at the last tick
    tool_.m = at_device.device.m - at_device.moved.v;
    gap_m_.setZero();
  }
  share = std::max(limit / (limit + effects_N_per_m_), share * (1.0 - kSoftensBy));
  const double softer = effects_N_per_m_ * share / (1.0 - share);
  softened_J_ = 0.5 * (stiffness_N_per_m_ - softer) * gap_m_.squaredNorm();
  stiffness_N_per_m_ = softer;
  engaged_ = true;
}

effects::EffectInput VirtualCoupling::at_tool(const effects::EffectInput& at_device) noexcept {
  const Eigen::Vector3d pulled_N = stiffness_N_per_m_ * (at_device.device.m - tool_.m);
  const Eigen::Vector3d step = (on_tool_N_ + pulled_N) / (stiffness_N_per_m_ + effects_N_per_m_);
  absorbed_J_ = on_tool_N_.dot(step) - on_device_N_.dot(at_device.moved.v) - softened_J_;
  tool_.m += step;
  gap_m_ = tool_.m - at_device.device.m;
  effects::EffectInput in = at_device;
  in.device = tool_;
  in.moved = {step};
  in.contact.distance_m += gap_m_.dot(in.contact.normal.v);
  in.contact.proxy.m += gap_m_ - gap_m_.dot(in.contact.normal.v) * in.contact.normal.v;
  return in;
}

Force<HapticBase> VirtualCoupling::pull(const Force<HapticBase>& on_tool) noexcept {
  on_tool_N_ = on_tool.N;
  on_device_N_ = stiffness_N_per_m_ * gap_m_;
  return {on_device_N_};
}

}  // namespace telepalp::control
