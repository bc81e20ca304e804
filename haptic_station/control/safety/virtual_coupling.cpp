#include "haptic_station/control/safety/virtual_coupling.h"

#include <algorithm>

namespace telepalp::control {

double stiffest_shown_N_per_m(const CouplingSettings& settings) noexcept {
  constexpr double kLeast_N_per_m = 400.0;
  return std::max(kLeast_N_per_m, settings.margin * 2.0 * settings.device_damping_N_s_per_m / settings.tick_s);
}

VirtualCoupling::VirtualCoupling(const CouplingSettings& settings, double effects_N_per_m) noexcept
    : effects_N_per_m_(effects_N_per_m),
      stiffness_N_per_m_(stiffest_shown_N_per_m(settings)),
      engaged_(settings.enabled && effects_N_per_m > stiffness_N_per_m_) {}

void VirtualCoupling::begin(const Point<HapticBase>& device) noexcept {
  tool_ = device;
  gap_m_.setZero();
  on_tool_N_.setZero();
}

effects::EffectInput VirtualCoupling::at_tool(const effects::EffectInput& at_device) noexcept {
  const Eigen::Vector3d pulled_N = stiffness_N_per_m_ * (at_device.device.m - tool_.m);
  const Eigen::Vector3d step = (on_tool_N_ + pulled_N) / (stiffness_N_per_m_ + effects_N_per_m_);
  absorbed_J_ = on_tool_N_.dot(step) - stiffness_N_per_m_ * gap_m_.dot(at_device.moved.v);
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
  return {stiffness_N_per_m_ * gap_m_};
}

}  // namespace telepalp::control
