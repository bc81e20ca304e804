#pragma once

#include "haptic_station/effects/effect.h"

namespace telepalp::control {

/// The device's properties that the coupling needs.
struct CouplingSettings {
  bool enabled = true;
  double device_damping_N_s_per_m = 1.0;
  double tick_s = 0.0005;
  double margin = 0.5;  ///< share of the stiffness that theory allows; the rest of the damping dissipates energy
};

/// The stiffest spring that a device with this damping can show without creating energy, when its force is held over a
/// tick: 2 b / T (Colgate and Schenkel 1997, eq. 20, without virtual damping). At least 400 N/m: by this formula a
/// device without friction could show nothing, and the passivity controller removes the energy that remains.
[[nodiscard]] double stiffest_shown_N_per_m(const CouplingSettings& settings) noexcept;

/// Colgate's virtual coupling: effects that are stiffer than the device can show act on a massless tool, and a spring
/// that the device can show connects the tool to the device. It is used only when the scene's effects together are too
/// stiff. The hand then feels both springs in series, which are never stiffer than the device can show.
///
/// Each tick moves the tool against the gradient of the energy of coupling and effects, by at most the inverse of their
/// stiffness. This is the implicit integration of a damper, so the energy falls at every tick length. Owner: control
/// thread.
class VirtualCoupling {
 public:
  /// `effects_N_per_m`: upper bound of the effects' combined stiffness.
  VirtualCoupling(const CouplingSettings& settings, double effects_N_per_m) noexcept;

  [[nodiscard]] bool engaged() const noexcept { return engaged_; }
  [[nodiscard]] double stiffness_N_per_m() const noexcept { return stiffness_N_per_m_; }

  /// Contact begins: the tool is at the device.
  void begin(const Point<HapticBase>& device) noexcept;

  /// Moves the tool and returns the effects' input at the tool, derived from their input at the device. Tool and device
  /// are millimetres apart; between them the surface counts as plane.
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
