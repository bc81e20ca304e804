#include "haptic_station/effects/organ.h"

namespace telepalp::effects {

SolidDepth Organ::depth_at(const Eigen::Vector3d& point_m) const noexcept {
  const solids::DistanceAt distance = solids::distance_at(*settings_.shape, point_m);
  return {-distance.m, distance.gradient};
}

Point<HapticBase> Organ::place() const noexcept {
  if (settings_.shape == nullptr) return {};
  const auto& size = settings_.shape->size;
  return {settings_.shape->origin_m +
          0.5 * settings_.shape->spacing_m * Eigen::Vector3d(size[0] - 1, size[1] - 1, size[2] - 1)};
}

Force<HapticBase> Organ::step(const EffectInput& in, double dt_s) noexcept {
  spring_ = {};
  touch_ = ObjectTouch::None;
  if (settings_.shape == nullptr) return {};
  const auto felt = entry_.step(in.device.m, in.contact.normal.v, dt_s,
                                [this](const Eigen::Vector3d& point) noexcept { return depth_at(point); });
  if (felt.depth_m <= 0.0) {
    if (-depth_at(in.device.m).m <= kAround_m) touch_ = ObjectTouch::Near;
    return {};
  }
  constexpr double kCos45 = 0.70710678118654752;
  const bool from_above = felt.outwards.y() >= kCos45 * felt.outwards.norm();
  touch_ = from_above ? ObjectTouch::Upper : ObjectTouch::Lateral;
  spring_ = {felt.share * settings_.stiffness_N_per_m, felt.depth_m, felt.outwards};
  return spring_.force(0.0);
}

}  // namespace telepalp::effects
