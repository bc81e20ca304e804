#include "haptic_station/effects/inner_sphere.h"

namespace telepalp::effects {

Force<HapticBase> InnerSphere::step(const EffectInput& in, double) noexcept {
  const Eigen::Vector3d from_center = in.device.m - settings_.center.m;
  const double distance_m = from_center.norm();
  const double depth_m = settings_.radius_m - distance_m;
  energy_J_ = 0.0;
  if (depth_m <= 0.0) {
    touch_ = -depth_m <= settings_.around_m ? ObjectTouch::Near : ObjectTouch::None;
    return {};
  }
  if (distance_m > 1e-6) outwards_ = from_center / distance_m;
  constexpr double kCos45 = 0.70710678118654752;
  touch_ = outwards_.y() >= kCos45 ? ObjectTouch::Upper : ObjectTouch::Lateral;
  energy_J_ = 0.5 * settings_.stiffness_N_per_m * depth_m * depth_m;
  return {settings_.stiffness_N_per_m * depth_m * outwards_};
}

}  // namespace telepalp::effects
