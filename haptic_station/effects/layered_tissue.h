#pragma once

#include <memory>
#include <utility>

#include "haptic_station/effects/effect.h"
#include "haptic_station/effects/laws/spring.h"
#include "haptic_station/tissue/layered_tissue.h"

namespace telepalp::effects {

struct LayeredTissueSettings {
  std::shared_ptr<const tissue::TissueModel> model;  ///< in the haptic base's frame H; nullptr: no force
  /// The needle's tip in the tool's axes. The needle points from the device point to it. Zero: the device point is the
  /// tip, and the needle points along the tool's -y.
  Eigen::Vector3d tip_m = Eigen::Vector3d::Zero();
  double skin_left = 1.0;  ///< share of the skin's stiffness that is left where the outermost surface is punctured
};

/// A needle in layers of tissue: tissue::LayeredTissue, which is paper S4 (docs/sources.md), section 3, as an effect.
///
/// Its forces come from anchors that follow the tip, which are state (effect.h). So EffectBank keeps holds_N() of the
/// device's force for it, and gives the springs of the scene the rest. Where the tissue's wrench exceeds this share, in
/// force or in torque, all anchors move towards the needle, which dissipates energy. On a device that can give
/// holds_N() this does not happen, also where the tip pushes several nets at once: each is punctured by its own force.
/// Holes last from one contact to the next; forces do not. The skin is weaker only while the needle is in a hole.
class LayeredTissue {
 public:
  static constexpr const char* kName = "layered_tissue";
  using Settings = LayeredTissueSettings;

  explicit LayeredTissue(Settings settings = {}) noexcept : settings_(std::move(settings)), tissue_(settings_.model) {}
  void begin(const EffectInput& in) noexcept;
  [[nodiscard]] Wrench<HapticBase> step(const EffectInput& in, double dt_s) noexcept;

  [[nodiscard]] Wrench<HapticBase> wrench(double relaxed_m, double share) noexcept;
  [[nodiscard]] double stored_J() const noexcept { return settings_.model ? tissue_.stored_J() : 0.0; }
  [[nodiscard]] double holds_N() const noexcept { return settings_.model ? weight_ * tissue_.most_N() : 0.0; }

  [[nodiscard]] double loaded_J(const EffectInput& in) const noexcept;
  [[nodiscard]] double skin_left() const noexcept;
  [[nodiscard]] Point<HapticBase> place() const noexcept;
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept {
    return settings_.model ? tissue_.stiffest_N_per_m() : 0.0;
  }
  [[nodiscard]] ObjectTouch touch() const noexcept;
  [[nodiscard]] const tissue::LayeredTissue& layers() const noexcept { return tissue_; }

 private:
  [[nodiscard]] tissue::NeedleMotion needle(const EffectInput& in) const noexcept;

  Settings settings_;
  tissue::LayeredTissue tissue_;
  Eigen::Vector3d lever_m_ = Eigen::Vector3d::Zero();  ///< from the device to the tip
  double N_per_N_m_ = 0.0;                             ///< ToolTurn::N_per_N_m of this contact
  double weight_ = 1.0;                                ///< of the lever in this contact, as in LeverSpring
};

}  // namespace telepalp::effects
