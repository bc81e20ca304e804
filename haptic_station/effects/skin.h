#pragma once

#include "haptic_station/effects/effect.h"
#include "haptic_station/effects/laws/skin_law.h"

namespace telepalp::effects {

struct TissuePreset;

/// Where the skin's indentation vector d starts.
enum class SkinAnchor {
  FollowsSurface,  ///< at the first contact point, which moves with the surface there
  Fixed,           ///< at the first contact point, fixed in H: paper S1 (docs/sources.md) eq. (8) as printed
  Sliding,         ///< at the proxy, so that the hand slides without friction (an extension that S1 mentions)
};

struct SkinSettings {
  SkinLaw law;
  SkinAnchor anchor = SkinAnchor::FollowsSurface;
  const TissuePreset* tissue = nullptr;  ///< one of kTissuePresets, which gave the law; nullptr: none did
};

/// The skin that pushes an indenting hand back (S1 II.D). On a plane at rest, FollowsSurface and Fixed give the same
/// force; a breathing patient needs FollowsSurface. The skin never pulls the hand into the body.
class Skin {
 public:
  static constexpr const char* kName = "skin";
  using Settings = SkinSettings;

  explicit Skin(const Settings& settings = {}) noexcept : settings_(settings), law_(settings.law) {}
  void begin(const EffectInput& in) noexcept;
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;
  [[nodiscard]] Pull pull(double relaxed_m) const noexcept { return skin_pull(law_, indentation_.v, relaxed_m); }
  [[nodiscard]] Force<HapticBase> force(double relaxed_m) const noexcept {
    return {skin_force_N(law_, indentation_.v, relaxed_m)};
  }
  [[nodiscard]] double energy_J(double relaxed_m = 0.0) const noexcept {
    return skin_energy_J(law_, indentation_.v, relaxed_m);
  }
  [[nodiscard]] Vector<HapticBase> carried_at(const EffectInput& in) const noexcept;
  [[nodiscard]] double stiffest_N_per_m(double most_N) const noexcept {
    return skin_stiffest_N_per_m(settings_.law, most_N);
  }
  [[nodiscard]] ObjectTouch touch() const noexcept { return ObjectTouch::None; }
  /// Leaves the share `skin_left` of the stiffness that the scene gives the skin.
  void weaken(double skin_left) noexcept { law_ = settings_.law.weakened(skin_left); }
  [[nodiscard]] const SkinLaw& law() const noexcept { return law_; }
  [[nodiscard]] const Vector<HapticBase>& indentation() const noexcept { return indentation_; }

 private:
  Settings settings_;
  SkinLaw law_;                      ///< that of `settings_`, weakened
  Point<HapticBase> first_contact_;  ///< S1's p_p^0: proxy at the start of the contact
  Vector<HapticBase> first_normal_;
  Eigen::Vector3d carried_m_ = Eigen::Vector3d::Zero();  ///< movement of the skin at the first contact point since then
  Vector<HapticBase> indentation_;                       ///< S1's d, eq. (8)
};

}  // namespace telepalp::effects
