#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "haptic_station/effects/effect.h"
#include "haptic_station/effects/laws/spring.h"
#include "haptic_station/tissue/fem/prism_model.h"
#include "haptic_station/tissue/fem/slewed_plane.h"
#include "proto/words/latest_value.h"

namespace telepalp::effects {

struct FemPrismSettings {
  std::shared_ptr<const tissue::PrismModel> model;  ///< nullptr: no force
  tissue::SlewSettings slew;
};

/// A soft prism that is pushed from the side, paper S3 (docs/sources.md), 8.4. It is an object beside the hand, not in
/// the patient: it stands still in H. Its deformation takes longer than a tick, so a slow stage computes it 62 times a
/// second, and this effect displays the local model of the last run (tissue::SlewedPlane). Energy that a newer model
/// adds is booked as taken from a tank, which is the effect's state.
class FemPrism {
 public:
  static constexpr const char* kName = "fem_prism";
  using Settings = FemPrismSettings;
  using LocalModel = tissue::LocalPlane;

  explicit FemPrism(const Settings& settings = {}) noexcept : settings_(settings), plane_(settings.slew) {}
  void take_models(std::shared_ptr<LatestValue<LocalModel>> from) noexcept { models_ = std::move(from); }

  void begin(const EffectInput& in) noexcept { plane_.begin(in.device.m); }
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;

  [[nodiscard]] Pull pull(double relaxed_m) const noexcept { return spring_.pull(relaxed_m); }
  [[nodiscard]] Force<HapticBase> force(double relaxed_m) const noexcept { return spring_.force(relaxed_m); }
  [[nodiscard]] double energy_J(double relaxed_m = 0.0) const noexcept { return spring_.energy_J(relaxed_m); }

  /// The tank gives no force. The call tells how far the bank has relaxed the spring.
  [[nodiscard]] Force<HapticBase> wrench(double relaxed_m, double) noexcept {
    relaxed_m_ = relaxed_m;
    return {};
  }
  /// The tank's level over that at the beginning of the contact; negative while models have added energy.
  [[nodiscard]] double stored_J() const noexcept { return plane_.tank().level_J() - begun_J(); }

  [[nodiscard]] Vector<HapticBase> carried_at(const EffectInput&) const noexcept { return {}; }
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept {
    return settings_.model ? settings_.slew.stiffest_N_per_m : 0.0;
  }
  [[nodiscard]] ObjectTouch touch() const noexcept { return touch_; }
  [[nodiscard]] const tissue::SlewedPlane& plane() const noexcept { return plane_; }

 private:
  [[nodiscard]] double begun_J() const noexcept { return std::min(settings_.slew.tank_J, settings_.slew.tank_holds_J); }

  Settings settings_;
  std::shared_ptr<LatestValue<LocalModel>> models_;
  tissue::SlewedPlane plane_;
  LinearSpring spring_;     ///< at the last step
  double relaxed_m_ = 0.0;  ///< of the spring since the last step
  ObjectTouch touch_ = ObjectTouch::None;
};

}  // namespace telepalp::effects
