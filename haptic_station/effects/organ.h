#pragma once

#include <memory>
#include <utility>

#include "haptic_station/effects/effect.h"
#include "haptic_station/effects/entry_side.h"
#include "haptic_station/effects/laws/spring.h"
#include "haptic_station/solids/distance_lattice.h"

namespace telepalp::effects {

struct OrganSettings {
  std::shared_ptr<const solids::DistanceLattice> shape;  ///< in the haptic base's frame H; nullptr: no force
  double stiffness_N_per_m = 300.0;
};

/// An organ inside the body, of any closed shape. The force is minus the gradient of 1/2 k depth^2 at the proxy of
/// EntrySide; the depth comes from a sampled distance field. It generalises the sphere of paper S1 (docs/sources.md)
/// II.D to scanned shapes.
class Organ {
 public:
  static constexpr const char* kName = "organ";
  using Settings = OrganSettings;

  explicit Organ(Settings settings = {}) noexcept : settings_(std::move(settings)) {}
  void begin(const EffectInput&) noexcept { entry_.forget(); }
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;
  [[nodiscard]] Pull pull(double relaxed_m) const noexcept { return spring_.pull(relaxed_m); }
  [[nodiscard]] Force<HapticBase> force(double relaxed_m) const noexcept { return spring_.force(relaxed_m); }
  [[nodiscard]] double energy_J(double relaxed_m = 0.0) const noexcept { return spring_.energy_J(relaxed_m); }
  /// The middle of the lattice `shape`.
  [[nodiscard]] Point<HapticBase> place() const noexcept;
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept { return settings_.stiffness_N_per_m; }
  [[nodiscard]] ObjectTouch touch() const noexcept { return touch_; }

 private:
  [[nodiscard]] SolidDepth depth_at(const Eigen::Vector3d& point_m) const noexcept;

  Settings settings_;
  EntrySide entry_;
  LinearSpring spring_;  ///< at the last step
  ObjectTouch touch_ = ObjectTouch::None;
};

}  // namespace telepalp::effects
