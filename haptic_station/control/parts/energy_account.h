#pragma once

#include "haptic_station/control/safety/passivity.h"

namespace telepalp::control {

/// Sums the energy that the effects take from the hand and return to it, and adds the passivity controller's damping.
/// The sum stays correct while the device gives less force than the effects ask for: while the contact is released
/// gradually, when the limiter reduces the force, and when the effects ask for more than `bound_N`. Owner: haptic
/// thread.
class EnergyAccount {
 public:
  /// Starts the balance of a new contact at zero.
  void begin() noexcept;

  /// Returns the force to display over the next tick [N], damping included. `asked_N`: the force of the effects, whose
  /// springs EffectBank has relaxed (spring.h) to `bound_N`. It can exceed `bound_N` slightly at a stiff region's rim,
  /// through the virtual coupling, and with friction on a skin that pushes to its anchor; step() then scales it down.
  /// `share`: displayed share of `asked_N`, 0 to 1; below 1 while the contact is released gradually. `exchange`: energy
  /// and motion between effects and hand in the last tick. `bound_N`: upper bound of the force of all effects together.
  [[nodiscard]] Eigen::Vector3d step(const Eigen::Vector3d& asked_N, double share, const Exchange& exchange,
                                     double bound_N, double dt_s) noexcept;

  /// Call after the limiter. `wanted_N`: the limiter's input. `given_N`: its output.
  void limited(const Eigen::Vector3d& given_N, const Eigen::Vector3d& wanted_N) noexcept;

  /// True when the force of the device differs from the one that the effects and the damping ask for.
  [[nodiscard]] bool withholds() const noexcept;
  [[nodiscard]] const Force<HapticBase>& damping() const noexcept { return damping_; }  ///< of the last step
  [[nodiscard]] const PassivityController& passivity() const noexcept { return passivity_; }

 private:
  PassivityController passivity_;
  Force<HapticBase> damping_;
  Eigen::Vector3d shown_N_ = Eigen::Vector3d::Zero();     ///< the effects' force that the last tick showed
  Eigen::Vector3d withheld_N_ = Eigen::Vector3d::Zero();  ///< force given minus force asked for, over the last tick
};

}  // namespace telepalp::control
