#include "haptic_station/effects/friction.h"

#include <algorithm>

namespace telepalp::effects {

Force<HapticBase> Friction::step(const EffectInput& in, double) noexcept {
  const Eigen::Vector3d& normal = in.contact.normal.v;
  bristle_m_ += in.moved.v;
  bristle_m_ -= bristle_m_.dot(normal) * normal;
  depth_m_ = std::max(0.0, -in.contact.distance_m);
  return slip(0.0);
}

Force<HapticBase> Friction::slip(double relaxed_m) noexcept {
  const double depth_m = std::max(0.0, depth_m_ - relaxed_m);
  const double holds_N = skin_left_ * settings_.coefficient * settings_.load.stiffness_N_per_m(depth_m) * depth_m;
  const double longest_m = holds_N / settings_.bristle_stiffness_N_per_m;
  const double length_m = bristle_m_.norm();
  if (length_m > longest_m) bristle_m_ *= longest_m / length_m;
  return {-settings_.bristle_stiffness_N_per_m * bristle_m_};
}

}  // namespace telepalp::effects
