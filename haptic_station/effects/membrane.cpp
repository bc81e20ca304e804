#include "haptic_station/effects/membrane.h"

#include <algorithm>

namespace telepalp::effects {

using Eigen::Vector3d;

void Membrane::begin(const EffectInput& in) noexcept {
  *this = Membrane(settings_);
  spring_.weight = lever_weight(settings_.tip_m.norm(), in.turn.N_per_N_m);
  tip_m_ = in.device.m + in.turn.attitude * settings_.tip_m;
}

double Membrane::longest_bristle_m(double depth_m) const noexcept {
  constexpr double kFull_m = 0.002;
  const double holds_N = (1.0 - whole_) * settings_.friction_N * std::clamp(depth_m / kFull_m, 0.0, 1.0);
  return holds_N / settings_.stiffness_N_per_m;
}

Wrench<HapticBase> Membrane::step(const EffectInput& in, double dt_s) noexcept {
  constexpr double kTears_s = 0.03;
  lever_m_ = in.turn.attitude * settings_.tip_m;
  const Vector3d tip_m = in.device.m + lever_m_;
  const double deep_m = depth_m(tip_m);
  bristle_m_ += tip_m - tip_m_;
  tip_m_ = tip_m;
  was_above_ = was_above_ || deep_m <= 0.0;
  const double felt_m = was_above_ ? std::max(0.0, deep_m) : 0.0;
  torn_ = torn_ || settings_.stiffness_N_per_m * felt_m > settings_.tears_at_N;
  if (torn_) whole_ = std::max(0.0, whole_ - dt_s / kTears_s);
  touch_ = felt_m > 0.0 && !torn_ ? ObjectTouch::Upper : ObjectTouch::None;
  spring_.spring = {whole_ * settings_.stiffness_N_per_m, felt_m, Vector3d::UnitY()};
  spring_.turning = lever_m_.cross(Vector3d::UnitY());
  Wrench<HapticBase> sum = wrench(0.0, 1.0);
  const Wrench<HapticBase> pushed = spring_.wrench(0.0);
  sum.force.N += pushed.force.N;
  sum.torque.N_m += pushed.torque.N_m;
  return sum;
}

/// The anchor follows the tip, and so only shortens the bristle.
Wrench<HapticBase> Membrane::wrench(double, double share) noexcept {
  const double longest_m = share * longest_bristle_m(depth_m(tip_m_));
  const double length_m = bristle_m_.norm();
  if (length_m > longest_m) bristle_m_ *= longest_m / length_m;
  const Vector3d force_N = -settings_.stiffness_N_per_m * bristle_m_;
  return {.force = {force_N}, .torque = {lever_m_.cross(force_N)}};
}

double Membrane::loaded_J(const EffectInput& in) const noexcept {
  const Vector3d tip_m = in.device.m + in.turn.attitude * settings_.tip_m;
  const double deep_m = depth_m(tip_m);
  const double felt_m = was_above_ ? std::max(0.0, deep_m) : 0.0;
  const double bristle_m = std::min((bristle_m_ + tip_m - tip_m_).norm(), longest_bristle_m(deep_m));
  return 0.5 * settings_.stiffness_N_per_m * (whole_ * felt_m * felt_m + bristle_m * bristle_m);
}

}  // namespace telepalp::effects
