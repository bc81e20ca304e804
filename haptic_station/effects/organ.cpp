#include "haptic_station/effects/organ.h"

namespace telepalp::effects {

Force<HapticBase> Organ::step(const EffectInput& in, double) noexcept {
  energy_J_ = 0.0;
  touch_ = ObjectTouch::None;
  if (settings_.shape == nullptr) return {};
  const DistanceAt distance = distance_at(*settings_.shape, in.device.m);
  if (distance.m >= 0.0) {
    if (distance.m <= settings_.around_m) touch_ = ObjectTouch::Near;
    return {};
  }
  constexpr double kCos45 = 0.70710678118654752;
  const bool from_above = distance.gradient.y() >= kCos45 * distance.gradient.norm();
  touch_ = from_above ? ObjectTouch::Upper : ObjectTouch::Lateral;
  energy_J_ = 0.5 * settings_.stiffness_N_per_m * distance.m * distance.m;
  return {-settings_.stiffness_N_per_m * distance.m * distance.gradient};
}

}  // namespace telepalp::effects
