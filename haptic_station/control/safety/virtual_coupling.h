#pragma once

#include "haptic_station/effects/effect.h"

namespace telepalp::control {

/// What the coupling knows of the device.
struct CouplingSettings {
  bool enabled = true;
  double device_damping_N_s_per_m = 1.0;
  double tick_s = 0.0005;
  double margin = 0.5;  ///< share of what theory allows: the rest of the damping calms
};

/// The stiffest spring that a device with so much damping can show without making energy when its force is held over a
/// tick: 2 b / T (Colgate and Schenkel 1997, eq. 20, without virtual damping). Not below 400 N/m: a device without
/// friction can show nothing by this measure, and the passivity controller is there.
[[nodiscard]] double stiffest_shown_N_per_m(const CouplingSettings& settings) noexcept;

/// Effects stiffer than the device can show are met through a spring that is not (Colgate's virtual coupling): they act
/// on a tool without mass, the tool pulls the device. Engaged only when the scene's effects together are that stiff;
/// the hand then feels both springs in series, at most what the device can show.
///
/// The tool goes down the energy of coupling and effects by a step no longer than the inverse of their stiffness, an
/// implicit integration of a damper: their energy only falls, whatever the tick. Owner: control thread.
class VirtualCoupling {
 public:
  /// `effects_N_per_m`: the stiffest that the effects can be, together.
  VirtualCoupling(const CouplingSettings& settings, double effects_N_per_m) noexcept;

  [[nodiscard]] bool engaged() const noexcept { return engaged_; }
  [[nodiscard]] double stiffness_N_per_m() const noexcept { return stiffness_N_per_m_; }

  /// Contact begins: the tool is at the device.
  void begin(const Point<HapticBase>& device) noexcept;

  /// The tool moves; what the effects may know of it, from what they might know of the device. The surface counts as
  /// plane between the two, which are millimetres apart.
  [[nodiscard]] effects::EffectInput at_tool(const effects::EffectInput& at_device) noexcept;

  /// The force on the device, when the effects act on the tool with `on_tool`.
  [[nodiscard]] Force<HapticBase> pull(const Force<HapticBase>& on_tool) noexcept;

  [[nodiscard]] double energy_J() const noexcept { return 0.5 * stiffness_N_per_m_ * gap_m_.squaredNorm(); }
  /// Work taken from the hand since the step before, beyond what the effects took from the tool [J].
  [[nodiscard]] double absorbed_J() const noexcept { return absorbed_J_; }

 private:
  double effects_N_per_m_;
  double stiffness_N_per_m_;
  bool engaged_;
  Point<HapticBase> tool_;
  Eigen::Vector3d gap_m_ = Eigen::Vector3d::Zero();      ///< tool less device
  Eigen::Vector3d on_tool_N_ = Eigen::Vector3d::Zero();  ///< of the effects, over the tick that ends
  double absorbed_J_ = 0.0;
};

}  // namespace telepalp::control
