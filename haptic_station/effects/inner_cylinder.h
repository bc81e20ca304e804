#pragma once

#include "haptic_station/effects/effect.h"
#include "haptic_station/effects/entry_side.h"
#include "haptic_station/effects/laws/spring.h"

namespace telepalp::effects {

struct InnerCylinderSettings {
  Point<HapticBase> top_center;
  double radius_m = 0.03;
  double height_m = 0.05;
  double stiffness_N_per_m = 800.0;
};

/// An upright cylinder inside the body (paper S1, docs/sources.md, III.A), given by radius, height and the centre of
/// its upper face. Its axis is the y axis of the haptic base (frame H).
///
/// S1 switches between a force on the upper face and one on the lateral face; at the rim the force then jumps. Here the
/// force is minus the gradient of 1/2 k s^2, where s is a smooth minimum of the depths under the upper, lower and
/// lateral faces. Near each face it equals the paper's k times depth, and it is continuous and conservative everywhere.
/// s is evaluated at the proxy of EntrySide, which stays in the half where the hand entered. S1's force, which points
/// to the nearest face, would draw a hand that has passed the middle out through the far face.
class InnerCylinder {
 public:
  static constexpr const char* kName = "cylinder";
  using Settings = InnerCylinderSettings;

  explicit InnerCylinder(const Settings& settings = {}) noexcept : settings_(settings) {}
  void begin(const EffectInput&) noexcept { entry_.forget(); }
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;
  [[nodiscard]] Pull pull(double relaxed_m) const noexcept { return spring_.pull(relaxed_m); }
  [[nodiscard]] Force<HapticBase> force(double relaxed_m) const noexcept { return spring_.force(relaxed_m); }
  [[nodiscard]] double energy_J(double relaxed_m = 0.0) const noexcept { return spring_.energy_J(relaxed_m); }
  [[nodiscard]] Point<HapticBase> place() const noexcept { return settings_.top_center; }
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept { return settings_.stiffness_N_per_m; }
  [[nodiscard]] ObjectTouch touch() const noexcept { return touch_; }

 private:
  [[nodiscard]] SolidDepth depth_at(const Eigen::Vector3d& from_top) const noexcept;

  Settings settings_;
  EntrySide entry_;
  LinearSpring spring_;  ///< at the last step
  ObjectTouch touch_ = ObjectTouch::None;
};

}  // namespace telepalp::effects
