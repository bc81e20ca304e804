#include "haptic_station/effects/fem_prism.h"

namespace telepalp::effects {

Force<HapticBase> FemPrism::step(const EffectInput& in, double dt_s) noexcept {
  constexpr double kCos45 = 0.70710678118654752;
  const double depth_m = plane_.depth_m();
  const double shown = depth_m > 0.0 ? std::clamp(1.0 - relaxed_m_ / depth_m, 0.0, 1.0) : 1.0;
  relaxed_m_ = 0.0;
  if (models_ && models_->take()) plane_.take(models_->current());
  plane_.step(in.device.m, dt_s, shown);
  spring_ = {plane_.stiffness_N_per_m(), plane_.depth_m(), plane_.normal()};
  touch_ = ObjectTouch::None;
  if (plane_.force_N() > 0.0)
    touch_ = plane_.normal().y() >= kCos45 ? ObjectTouch::Upper : ObjectTouch::Lateral;
  else if (plane_.follows() && plane_.model().usable() && -plane_.signed_depth_m() <= kAround_m)
    touch_ = ObjectTouch::Near;
  return spring_.force(0.0);
}

}  // namespace telepalp::effects
