#pragma once

#include "haptic_station/effects/effect.h"

namespace telepalp::effects {

struct InnerSphereSettings {
  Point<HapticBase> center;
  double radius_m = 0.02;
  double stiffness_N_per_m = 800.0;
  double around_m = 0.01;  ///< within this distance of the sphere, touch() is Near
};

/// A sphere inside the body (S1 II.D): F = k (r - |x - c|), outwards. touch() is Upper when the sphere is pressed from
/// within 45 degrees of the upward vertical.
class InnerSphere {
 public:
  static constexpr const char* kName = "sphere";
  using Settings = InnerSphereSettings;

  explicit InnerSphere(const Settings& settings = {}) noexcept : settings_(settings) {}
  void begin(const EffectInput&) noexcept {}
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;
  [[nodiscard]] double energy_J() const noexcept { return energy_J_; }
  [[nodiscard]] Vector<HapticBase> carried_at(const EffectInput&) const noexcept { return {}; }
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept { return settings_.stiffness_N_per_m; }
  [[nodiscard]] ObjectTouch touch() const noexcept { return touch_; }

 private:
  Settings settings_;
  Eigen::Vector3d outwards_ = Eigen::Vector3d::UnitY();  ///< last direction from the centre to the device
  double energy_J_ = 0.0;
  ObjectTouch touch_ = ObjectTouch::None;
};

}  // namespace telepalp::effects
