#include "haptic_station/effects/inner_sphere.h"

namespace telepalp::effects {

SolidDepth InnerSphere::depth_at(const Eigen::Vector3d& from_center) const noexcept {
  constexpr double kCore = 0.1;  // of the radius
  const double core_m = kCore * settings_.radius_m;
  const double distance_m = from_center.norm();
  if (distance_m >= core_m) return {settings_.radius_m - distance_m, from_center / distance_m};
  const double rounded_m = 0.5 * (distance_m * distance_m / core_m + core_m);
  return {settings_.radius_m - rounded_m, from_center / core_m};
}

Force<HapticBase> InnerSphere::step(const EffectInput& in, double dt_s) noexcept {
  const Eigen::Vector3d from_center = in.device.m - settings_.center.m;
  const auto felt = entry_.step(from_center, in.contact.normal.v, dt_s,
                                [this](const Eigen::Vector3d& point) noexcept { return depth_at(point); });
  spring_ = {};
  if (felt.depth_m <= 0.0) {
    touch_ = from_center.norm() <= settings_.radius_m + kAround_m ? ObjectTouch::Near : ObjectTouch::None;
    return {};
  }
  constexpr double kCos45 = 0.70710678118654752;
  touch_ = felt.outwards.y() >= kCos45 * felt.outwards.norm() ? ObjectTouch::Upper : ObjectTouch::Lateral;
  spring_ = {felt.share * settings_.stiffness_N_per_m, felt.depth_m, felt.outwards};
  return spring_.force(0.0);
}

}  // namespace telepalp::effects
