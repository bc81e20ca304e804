#pragma once

#include "haptic_station/effects/effect.h"
#include "haptic_station/effects/entry_side.h"
#include "haptic_station/effects/laws/spring.h"

namespace telepalp::effects {

struct InnerSphereSettings {
  Point<HapticBase> center;
  double radius_m = 0.02;
  double stiffness_N_per_m = 800.0;
};

/// A sphere inside the body (paper S1, docs/sources.md, II.D): F = k (r - |x - c|), outwards, with stiffness k, radius
/// r and centre c. The proxy x stays on the side of the sphere on which the hand entered (entry_side.h). Once the hand
/// has passed the centre, the force has no component along the direction of entry, so the sphere never pulls the hand
/// out at its far side. Within r / 10 of the centre the force falls to zero, because it has no direction there. touch()
/// is Upper when the sphere is pressed from within 45 degrees of the upward vertical.
class InnerSphere {
 public:
  static constexpr const char* kName = "sphere";
  using Settings = InnerSphereSettings;

  explicit InnerSphere(const Settings& settings = {}) noexcept : settings_(settings) {}
  void begin(const EffectInput&) noexcept { entry_.forget(); }
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;
  [[nodiscard]] Pull pull(double relaxed_m) const noexcept { return spring_.pull(relaxed_m); }
  [[nodiscard]] Force<HapticBase> force(double relaxed_m) const noexcept { return spring_.force(relaxed_m); }
  [[nodiscard]] double energy_J(double relaxed_m = 0.0) const noexcept { return spring_.energy_J(relaxed_m); }
  [[nodiscard]] Point<HapticBase> place() const noexcept { return settings_.center; }
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept { return settings_.stiffness_N_per_m; }
  [[nodiscard]] ObjectTouch touch() const noexcept { return touch_; }

 private:
  [[nodiscard]] SolidDepth depth_at(const Eigen::Vector3d& from_center) const noexcept;

  Settings settings_;
  EntrySide entry_;
  LinearSpring spring_;  ///< at the last step
  ObjectTouch touch_ = ObjectTouch::None;
};

}  // namespace telepalp::effects
