#pragma once

#include "haptic_station/control/safety/passivity.h"

namespace telepalp::control {

/// Keeps the energy balance between the effects and the hand, also while the device gives less force than the effects
/// ask for, and adds the passivity controller's damping. Owner: control thread.
class EnergyAccount {
 public:
  /// Starts the balance of a new contact at zero.
  void begin() noexcept;

  /// Returns the force to show for the next tick [N], damping included. `asked_N`: the force that the effects ask for.
  /// `share`: the part of it that is shown; 1 unless the contact is being released. `exchange`: the energy that passed
  /// between the effects and the hand over the last tick. `bound_N`: the largest force that the limiter lets through
  /// now.
  [[nodiscard]] Eigen::Vector3d step(const Eigen::Vector3d& asked_N, double share, const Exchange& exchange,
                                     double bound_N, double dt_s) noexcept;

  /// Call after the limiter, which turned `wanted_N` into `given_N`.
  void limited(const Eigen::Vector3d& given_N, const Eigen::Vector3d& wanted_N) noexcept;

  /// True when the device gives another force than the effects ask for.
  [[nodiscard]] bool withholds() const noexcept;
  [[nodiscard]] const Force<HapticBase>& damping() const noexcept { return damping_; }  ///< of the last step
  [[nodiscard]] const PassivityController& passivity() const noexcept { return passivity_; }

 private:
  PassivityController passivity_;
  Force<HapticBase> damping_;
  Eigen::Vector3d withheld_N_ = Eigen::Vector3d::Zero();  ///< force given minus force asked for, over the last tick
};

}  // namespace telepalp::control
