#pragma once

#include "haptic_station/effects/effect.h"

namespace telepalp::control {

/// The device's properties that the coupling needs.
struct CouplingSettings {
  bool enabled = true;
  double device_damping_N_s_per_m = 1.0;
  double tick_s = 0.0005;
  double margin = 0.5;  ///< used / largest passive stiffness; at 0.5, half of the device's damping stays in reserve
};

/// The stiffest spring that a device with damping b can display without creating energy, when its force is held over a
/// tick T: `margin` times 2 b / T (Colgate and Schenkel 1997, eq. 20, without virtual damping), but at least 400 N/m.
/// By the formula, a device without damping could display no spring; the passivity controller removes the energy that a
/// stiffer spring creates.
[[nodiscard]] double stiffest_shown_N_per_m(const CouplingSettings& settings) noexcept;

/// Colgate's virtual coupling: effects that are stiffer than the device can display act on a massless tool, and a
/// spring that the device can display connects the tool to the device. It is used only when the scene's effects
/// together are too stiff. The hand then feels both springs in series, which are softer than the coupling's spring.
///
/// Each tick moves the tool against the gradient of the energy of coupling and effects. The step is the gradient
/// divided by the sum of both stiffnesses, like an implicit step of a damped massless tool, so the energy falls at
/// every tick length. Owner: haptic thread.
class VirtualCoupling {
 public:
  /// `effects_N_per_m`: upper bound of the effects' combined stiffness.
  VirtualCoupling(const CouplingSettings& settings, double effects_N_per_m) noexcept;

  [[nodiscard]] bool engaged() const noexcept { return engaged_; }
  [[nodiscard]] double stiffness_N_per_m() const noexcept { return stiffness_N_per_m_; }

  /// Contact begins: the tool is at the device.
  void begin(const Point<HapticBase>& device) noexcept;

  /// Moves the tool and returns the input of the effects at the tool, converted from their input at the device. Tool
  /// and device are millimetres apart, so the surface between them is approximated by a plane.
  [[nodiscard]] effects::EffectInput at_tool(const effects::EffectInput& at_device) noexcept;

  /// The force on the device when the effects act on the tool with the force `on_tool`.
  [[nodiscard]] Force<HapticBase> pull(const Force<HapticBase>& on_tool) noexcept;

  [[nodiscard]] double energy_J() const noexcept { return 0.5 * stiffness_N_per_m_ * gap_m_.squaredNorm(); }
  /// Work taken from the hand over the last step, minus the work that the effects took from the tool [J].
  [[nodiscard]] double absorbed_J() const noexcept { return absorbed_J_; }

 private:
  double effects_N_per_m_;
  double stiffness_N_per_m_;
  bool engaged_;
  Point<HapticBase> tool_;
  Eigen::Vector3d gap_m_ = Eigen::Vector3d::Zero();      ///< vector from device to tool
  Eigen::Vector3d on_tool_N_ = Eigen::Vector3d::Zero();  ///< force of the effects on the tool during the last tick
  double absorbed_J_ = 0.0;
};

}  // namespace telepalp::control
