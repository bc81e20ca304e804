#pragma once

#include "haptic_station/effects/effect.h"
#include "haptic_station/effects/laws/skin_law.h"

namespace telepalp::effects {

struct FrictionSettings {
  double coefficient = 0.4;                  ///< Coulomb's: greatest tangential force / normal load
  double bristle_stiffness_N_per_m = 800.0;  ///< tangential stiffness of the skin before it slips
  SkinLaw load;                              ///< normal load: the law of the scene's skin at the device's depth
};

/// Dry friction of the skin against a sliding hand, after Hayward and Armstrong: a spring, the bristle, joins an anchor
/// on the skin to the device in the tangent plane. While the spring force is below coefficient × load, the anchor does
/// not move, so a resting hand does not creep. Above it, the anchor slips until the spring force equals coefficient ×
/// load. The anchor can only shorten the bristle, so friction is passive. The load is the force that the skin displays:
/// friction gets weaker when EffectBank relaxes the skin.
class Friction {
 public:
  static constexpr const char* kName = "friction";
  using Settings = FrictionSettings;

  explicit Friction(const Settings& settings = {}) noexcept : settings_(settings) {}
  void begin(const EffectInput&) noexcept { bristle_m_.setZero(); }
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;
  /// Lets the anchor slip under a skin that is relaxed by `relaxed_m`. Returns the force.
  [[nodiscard]] Force<HapticBase> slip(double relaxed_m) noexcept;
  [[nodiscard]] Force<HapticBase> wrench(double relaxed_m, double) noexcept { return slip(relaxed_m); }
  [[nodiscard]] double stored_J() const noexcept {
    return 0.5 * settings_.bristle_stiffness_N_per_m * bristle_m_.squaredNorm();
  }
  /// The skin under the hand has the share `skin_left` of its stiffness, and with it of its load.
  void weaken(double skin_left) noexcept { skin_left_ = skin_left; }
  [[nodiscard]] double coefficient() const noexcept { return settings_.coefficient; }
  [[nodiscard]] Vector<HapticBase> carried_at(const EffectInput&) const noexcept { return {}; }
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept { return settings_.bristle_stiffness_N_per_m; }
  [[nodiscard]] ObjectTouch touch() const noexcept { return ObjectTouch::None; }

 private:
  Settings settings_;
  Eigen::Vector3d bristle_m_ = Eigen::Vector3d::Zero();  ///< tangential vector from anchor to device
  double depth_m_ = 0.0;                                 ///< of the device in the skin
  double skin_left_ = 1.0;
};

}  // namespace telepalp::effects
