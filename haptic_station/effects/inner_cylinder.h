#pragma once

#include "haptic_station/effects/effect.h"

namespace telepalp::effects {

struct InnerCylinderSettings {
  Point<HapticBase> top_center;
  double radius_m = 0.03;
  double height_m = 0.05;
  double stiffness_N_per_m = 800.0;
  double around_m = 0.01;  ///< margin in which the hand is "around" it
};

/// An upright cylinder inside the body (S1 III.A): radius, height, its upper face's centre in H. Its axis is H's y.
///
/// S1 switches between an upper and a lateral force; at the rim that is a step of stiffness times depth. Here the
/// force is the gradient of 1/2 k s^2, with s a smooth minimum of the depths under the upper, lower and lateral faces:
/// it is the paper's k times depth near each face, and it is conservative and without a step everywhere.
class InnerCylinder {
 public:
  static constexpr const char* kName = "cylinder";
  using Settings = InnerCylinderSettings;

  explicit InnerCylinder(const Settings& settings = {}) noexcept : settings_(settings) {}
  void begin(const EffectInput&) noexcept {}
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;
  [[nodiscard]] double energy_J() const noexcept { return energy_J_; }
  [[nodiscard]] Vector<HapticBase> carried_at(const EffectInput&) const noexcept { return {}; }
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept { return settings_.stiffness_N_per_m; }
  [[nodiscard]] ObjectTouch touch() const noexcept { return touch_; }

 private:
  Settings settings_;
  double energy_J_ = 0.0;
  ObjectTouch touch_ = ObjectTouch::None;
};

}  // namespace telepalp::effects
