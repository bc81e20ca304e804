#include "haptic_station/effects/solid.h"

#include <cmath>
#include <numbers>

namespace telepalp::effects {

/// A quick systole and a slow diastole: sin^2 over the first third of the period.
double Solid::swell_m(double phase) const noexcept {
  constexpr double kSystole = 1.0 / 3.0;
  if (settings_.pulse_m == 0.0 || phase >= kSystole) return 0.0;
  const double rise = std::sin(std::numbers::pi * phase / kSystole);
  return settings_.pulse_m * rise * rise;
}

Point<HapticBase> Solid::place() const noexcept {
  if (!settings_.layer) return {};
  const solids::Box& box = settings_.layer->tree->box();
  return box.bounded() ? Point<HapticBase>{0.5 * (box.low + box.high)} : Point<HapticBase>{};
}

Vector<HapticBase> Solid::wall_velocity(double dt_s) const noexcept {
  if (settings_.pulse_m == 0.0 || !(dt_s > 0.0) || felt_.depth_m <= 0.0) return {};
  const double next = std::fmod(phase_ + settings_.pulses_per_s * dt_s, 1.0);
  return {(swell_m(next) - swell_m(phase_)) / dt_s * felt_.outwards};
}

void Solid::begin(const EffectInput& in) noexcept {
  proxy_.forget();
  tip_center_m_ = settings_.tip_radius_m * in.contact.normal.v;
}

Force<HapticBase> Solid::step(const EffectInput& in, double dt_s) noexcept {
  spring_ = {};
  touch_ = ObjectTouch::None;
  if (!settings_.layer) return {};
  const solids::SolidTree& tree = *settings_.layer->tree;
  phase_ = std::fmod(phase_ + settings_.pulses_per_s * dt_s, 1.0);
  const Eigen::Vector3d tip = in.device.m + tip_center_m_;
  felt_ = proxy_.step(tree, tip, settings_.tip_radius_m + swell_m(phase_));
  if (felt_.depth_m <= 0.0) {
    const double near_m = settings_.tip_radius_m + kAround_m;
    if (tree.box().squared_distance_m2(tip) <= near_m * near_m && solids::solid_at(tree, tip).m <= near_m)
      touch_ = ObjectTouch::Near;
    return {};
  }
  constexpr double kCos45 = 0.70710678118654752;
  touch_ = felt_.outwards.y() >= kCos45 ? ObjectTouch::Upper : ObjectTouch::Lateral;
  spring_ = {settings_.stiffness_N_per_m, felt_.depth_m, felt_.outwards};
  return spring_.force(0.0);
}

}  // namespace telepalp::effects
