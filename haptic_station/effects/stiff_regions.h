#pragma once

#include <array>
#include <string>
#include <vector>

#include "haptic_station/effects/effect.h"
#include "haptic_station/effects/laws/spring.h"

namespace telepalp::effects {

/// A vertical cylinder through the skin in which the skin is stiffer. Vertical is the y axis of the haptic base.
struct StiffRegion {
  Point<HapticBase> center;      ///< only x and z are used
  double radius_m = 0.02;        ///< radius of full added stiffness
  double fade_m = 0.02;          ///< width of the rim over which the added stiffness falls to 0
  double added_N_per_m = 200.0;  ///< added to the skin's own stiffness
};

/// A region with its name, which only pictures show.
struct NamedRegion {
  std::string name;
  StiffRegion region;
};

/// At most StiffRegions::kMostRegions regions.
struct StiffRegionsSettings {
  std::vector<NamedRegion> regions;
};

/// Skin regions of added stiffness. The force is minus the gradient of 1/2 k w(r) depth^2, with the depth of the device
/// in the skin and a smooth weight w of the horizontal distance r from the region's axis; the forces of overlapping
/// regions are summed. The gradient has a sideways component at a stiff rim; without it, a closed path over the rim
/// would create energy. Each region is one spring of stiffness k with the depth sqrt(w) depth.
class StiffRegions {
 public:
  static constexpr const char* kName = "regions";
  using Settings = StiffRegionsSettings;
  static constexpr std::size_t kMostRegions = 8;

  StiffRegions() noexcept = default;
  explicit StiffRegions(const Settings& settings) noexcept;
  /// False when there are already kMostRegions regions.
  bool add(const StiffRegion& region) noexcept;
  void begin(const EffectInput&) noexcept {}
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;
  /// Leaves the share `skin_left` of the added stiffness.
  void weaken(double skin_left) noexcept { skin_left_ = skin_left; }
  [[nodiscard]] Pull pull(double relaxed_m) const noexcept;
  [[nodiscard]] Force<HapticBase> force(double relaxed_m) const noexcept;
  [[nodiscard]] double energy_J(double relaxed_m = 0.0) const noexcept;
  [[nodiscard]] Vector<HapticBase> carried_at(const EffectInput& in) const noexcept {
    return {in.contact.surface_speed_m_per_s * in.contact.normal.v};
  }
  /// The sum over all regions, as if all of them overlapped.
  [[nodiscard]] double stiffest_N_per_m(double most_N) const noexcept;
  [[nodiscard]] ObjectTouch touch() const noexcept { return ObjectTouch::None; }

 private:
  std::array<StiffRegion, kMostRegions> regions_{};
  std::array<LinearSpring, kMostRegions> springs_{};  ///< of each region, at the last step
  std::size_t count_ = 0;
  double skin_left_ = 1.0;
};

}  // namespace telepalp::effects
