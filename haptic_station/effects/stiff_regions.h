#pragma once

#include <array>

#include "haptic_station/effects/effect.h"

namespace telepalp::effects {

/// A round region of the skin, seen along H's y, that is stiffer than the rest.
struct StiffRegion {
  Point<HapticBase> center;      ///< its y does not matter
  double radius_m = 0.02;        ///< full stiffness within
  double fade_m = 0.02;          ///< width of the rim over which it falls to nothing
  double added_N_per_m = 200.0;  ///< to the skin's own stiffness
};

/// Stiffness by region. The force is the gradient of 1/2 k w(r) depth^2 with a smooth w, overlapping regions added:
/// it also pushes sideways off a stiff rim, without which a loop over the rim would make energy.
class StiffRegions {
 public:
  static constexpr const char* kName = "regions";
  static constexpr std::size_t kMostRegions = 8;

  /// False when there is no room.
  bool add(const StiffRegion& region) noexcept;
  void begin(const EffectInput&) noexcept {}
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;
  [[nodiscard]] double energy_J() const noexcept { return energy_J_; }
  [[nodiscard]] Vector<HapticBase> carried_at(const EffectInput& in) const noexcept {
    return {in.contact.surface_speed_m_per_s * in.contact.normal.v};
  }
  /// As if all regions lay in one place.
  [[nodiscard]] double stiffest_N_per_m(double most_N) const noexcept;
  [[nodiscard]] ObjectTouch touch() const noexcept { return ObjectTouch::None; }

 private:
  std::array<StiffRegion, kMostRegions> regions_{};
  std::size_t count_ = 0;
  double energy_J_ = 0.0;
};

}  // namespace telepalp::effects
