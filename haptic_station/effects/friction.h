#pragma once

#include "haptic_station/effects/effect.h"
#include "haptic_station/effects/skin_law.h"

namespace telepalp::effects {

struct FrictionSettings {
  double coefficient = 0.4;                  ///< of Coulomb: share of the load that the skin holds sideways
  double bristle_stiffness_N_per_m = 800.0;  ///< of the skin's give before it slips
  SkinLaw load;                              ///< what presses: the scene's skin, as deep as the device is
};

/// Dry friction of the skin against a sliding hand, after Hayward and Armstrong: a bristle from an anchor on the skin
/// to the device, in the tangent plane. Below coefficient times load the anchor does not move at all, so a held hand
/// does not creep; above it, the anchor follows at just that force. The anchor only ever shortens the bristle: passive.
class Friction {
 public:
  static constexpr const char* kName = "friction";
  using Settings = FrictionSettings;

  explicit Friction(const Settings& settings = {}) noexcept : settings_(settings) {}
  void begin(const EffectInput&) noexcept { bristle_m_.setZero(); }
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;
  [[nodiscard]] double energy_J() const noexcept {
    return 0.5 * settings_.bristle_stiffness_N_per_m * bristle_m_.squaredNorm();
  }
  [[nodiscard]] Vector<HapticBase> carried_at(const EffectInput&) const noexcept { return {}; }
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept { return settings_.bristle_stiffness_N_per_m; }
  [[nodiscard]] ObjectTouch touch() const noexcept { return ObjectTouch::None; }

 private:
  Settings settings_;
  Eigen::Vector3d bristle_m_ = Eigen::Vector3d::Zero();  ///< device less anchor, tangential
};

}  // namespace telepalp::effects
