#pragma once

#include "haptic_station/effects/effect.h"

namespace telepalp::control {

/// The device's properties that the coupling needs.
struct CouplingSettings {
  bool enabled = true;
  double device_damping_N_s_per_m = 1.0;
  double tick_s = 0.0005;
  double loop_delay_s = 0.0;  ///< Td: age of the device's reading plus age of its command, when the force acts
  double margin = 0.5;  ///< used / largest passive stiffness; at 0.5, half of the device's damping stays in reserve
};

/// The stiffest spring that a device with damping b can display without creating energy, when its force is held over a
/// tick T and comes Td late: `margin` times b / (T / 2 + Td) (Diolaiti, Niemeyer, Barbagli and Salisbury 2006; without
/// delay it is eq. 20 of Colgate and Schenkel 1997, without virtual damping). There is no least stiffness: a device
/// without damping can display no spring.
[[nodiscard]] double stiffest_shown_N_per_m(const CouplingSettings& settings) noexcept;

/// Colgate's virtual coupling: effects that are stiffer than the device can display act on a massless tool, and a
/// spring that the device can display connects the tool to the device. It is used only when the scene's effects
/// together are too stiff. The hand then feels both springs in series, which are softer than the coupling's spring.
///
/// Each tick moves the tool against the gradient of the energy of coupling and effects. The step is the gradient
/// divided by the sum of both stiffnesses, like an implicit step of a damped massless tool, so the energy falls at
/// every tick length.
///
/// The spring's stiffness follows the device's measured loop delay. During a contact it only becomes softer: a spring
/// that becomes stiffer under load would give energy to the hand. It softens gradually (at 10 N, by at most 0.03 N a
/// tick), and the energy that it loses is never returned. The next contact begins with the limit that holds then.
/// Owner: haptic thread.
class VirtualCoupling {
 public:
  /// `effects_N_per_m`: upper bound of the effects' combined stiffness.
  VirtualCoupling(const CouplingSettings& settings, double effects_N_per_m) noexcept;

  [[nodiscard]] bool engaged() const noexcept { return engaged_; }
  /// Stiffness of the spring in use; meaningless unless engaged().
  [[nodiscard]] double stiffness_N_per_m() const noexcept { return stiffness_N_per_m_; }
  /// The stiffest spring that the device can display now.
  [[nodiscard]] double limit_N_per_m() const noexcept { return stiffest_shown_N_per_m(settings_); }
  [[nodiscard]] double effects_N_per_m() const noexcept { return effects_N_per_m_; }

  /// Sets the device's loop delay, from which the limit follows.
  void delayed_by(double loop_delay_s) noexcept { settings_.loop_delay_s = loop_delay_s; }

  /// Contact begins: the tool is at the device.
  void begin(const Point<HapticBase>& device) noexcept;

  /// Softens the spring for one tick if it is stiffer than the limit. Engages the coupling if the effects are stiffer
  /// than the limit. Call it in contact, before at_tool() and with the same input.
  void soften(const effects::EffectInput& at_device) noexcept;
  /// Records a tick in which the effects acted on the device itself, with the force `on_device`.
  void stand_by(const Force<HapticBase>& on_device) noexcept { on_tool_N_ = on_device_N_ = on_device.N; }

  /// Moves the tool and returns the input of the effects at the tool, converted from their input at the device. Tool
  /// and device are millimetres apart, so the surface between them is approximated by a plane.
  [[nodiscard]] effects::EffectInput at_tool(const effects::EffectInput& at_device) noexcept;

  /// The force on the device when the effects act on the tool with the force `on_tool`.
  [[nodiscard]] Force<HapticBase> pull(const Force<HapticBase>& on_tool) noexcept;

  [[nodiscard]] double energy_J() const noexcept { return 0.5 * stiffness_N_per_m_ * gap_m_.squaredNorm(); }
  /// Work taken from the hand over the last step, minus the work that the effects took from the tool, minus the energy
  /// that the spring lost by softening [J].
  [[nodiscard]] double absorbed_J() const noexcept { return absorbed_J_; }

 private:
  CouplingSettings settings_;
  double effects_N_per_m_;
  double stiffness_N_per_m_;
  bool engaged_;
  Point<HapticBase> tool_;
  Eigen::Vector3d gap_m_ = Eigen::Vector3d::Zero();        ///< vector from device to tool
  Eigen::Vector3d on_tool_N_ = Eigen::Vector3d::Zero();    ///< force of the effects on the tool during the last tick
  Eigen::Vector3d on_device_N_ = Eigen::Vector3d::Zero();  ///< force on the device during the last tick
  double absorbed_J_ = 0.0;
  double softened_J_ = 0.0;  ///< energy that the spring lost in the last soften()
};

}  // namespace telepalp::control
