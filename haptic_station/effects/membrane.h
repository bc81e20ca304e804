#pragma once

#include "haptic_station/effects/effect.h"
#include "haptic_station/effects/laws/spring.h"

namespace telepalp::effects {

struct MembraneSettings {
  Point<HapticBase> at;              ///< the membrane is the level plane through this point
  double stiffness_N_per_m = 500.0;  ///< of the whole membrane, and of the friction before it slips
  double tears_at_N = 2.5;           ///< paper S4 (docs/sources.md): the threshold of eq. (6)
  double friction_N = 0.3;           ///< C_3 of S4 eq. (7): friction of the torn membrane
  double skin_left = 1.0;            ///< share of the skin's stiffness that is left once the membrane is torn
  /// The point that meets the membrane, as a needle's tip, in the tool's axes; zero: the device point.
  Eigen::Vector3d tip_m = Eigen::Vector3d::Zero();
};

/// A membrane inside the body that a tool deforms, tears and passes through, as the amniotic sac of paper S4
/// (docs/sources.md), section 3. S4's mesh of springs is a level plane here, with one spring at the tip.
///
/// Whole, it pushes the tip back by stiffness × depth: the sum of the vertex forces of S4 eq. (6). Above tears_at_N it
/// tears for the rest of the contact. Its stiffness falls to zero within 30 ms, where S4 drops the force at once; the
/// energy of the spring is dissipated. From then on a friction of at most friction_N opposes the tip's motion (S4 eq.
/// 7). S4's constant force along -v/|v| reverses at rest, where it would chatter. Here a bristle as in Friction carries
/// the same force, and holds a resting tip. Over the first 2 mm below the plane the friction rises to friction_N.
///
/// A contact that begins below the plane feels nothing until the tip has been above it.
class Membrane {
 public:
  static constexpr const char* kName = "membrane";
  using Settings = MembraneSettings;

  explicit Membrane(const Settings& settings = {}) noexcept : settings_(settings) {}
  void begin(const EffectInput& in) noexcept;
  [[nodiscard]] Wrench<HapticBase> step(const EffectInput& in, double dt_s) noexcept;

  [[nodiscard]] Pull pull(double relaxed_m) const noexcept { return spring_.pull(relaxed_m); }
  [[nodiscard]] Wrench<HapticBase> force(double relaxed_m) const noexcept { return spring_.wrench(relaxed_m); }
  [[nodiscard]] double energy_J(double relaxed_m = 0.0) const noexcept { return spring_.energy_J(relaxed_m); }

  [[nodiscard]] Wrench<HapticBase> wrench(double relaxed_m, double share) noexcept;
  [[nodiscard]] double stored_J() const noexcept {
    return 0.5 * settings_.stiffness_N_per_m * bristle_m_.squaredNorm();
  }
  [[nodiscard]] double holds_N() const noexcept { return spring_.weight * settings_.friction_N; }

  [[nodiscard]] double loaded_J(const EffectInput& in) const noexcept;
  [[nodiscard]] double skin_left() const noexcept { return 1.0 - (1.0 - whole_) * (1.0 - settings_.skin_left); }
  [[nodiscard]] Point<HapticBase> place() const noexcept { return settings_.at; }
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept {
    return (settings_.friction_N > 0.0 ? 2.0 : 1.0) * settings_.stiffness_N_per_m;
  }
  [[nodiscard]] ObjectTouch touch() const noexcept { return touch_; }
  [[nodiscard]] bool torn() const noexcept { return torn_; }

 private:
  /// Of the tip below the plane [m].
  [[nodiscard]] double depth_m(const Eigen::Vector3d& tip_m) const noexcept { return settings_.at.m.y() - tip_m.y(); }
  [[nodiscard]] double longest_bristle_m(double depth_m) const noexcept;

  Settings settings_;
  LeverSpring spring_;                                   ///< at the last step
  Eigen::Vector3d lever_m_ = Eigen::Vector3d::Zero();    ///< from the device to the tip
  Eigen::Vector3d tip_m_ = Eigen::Vector3d::Zero();      ///< at the last step, relative to the membrane's displacement
  Eigen::Vector3d bristle_m_ = Eigen::Vector3d::Zero();  ///< from its anchor to the tip
  double whole_ = 1.0;                                   ///< share of the stiffness that acts
  bool was_above_ = false;
  bool torn_ = false;
  ObjectTouch touch_ = ObjectTouch::None;
};

}  // namespace telepalp::effects
