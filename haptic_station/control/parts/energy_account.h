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

  /// Returns the wrench to display over the next tick, damping included. `asked`: the wrench of the effects, whose
  /// springs EffectBank has relaxed (spring.h) to `bound_N`. Its force can exceed `bound_N` slightly at a stiff
  /// region's rim, through the virtual coupling, and with friction on a skin that pushes to its anchor; step() then
  /// scales it down. `share`: displayed share of `asked`, 0 to 1; below 1 while the contact is released gradually.
  /// `exchange`: energy and motion between effects and hand in the last tick. `bound_N`: upper bound of the force of
  /// all effects together. The torque of `asked` is displayed as far as `exchange.lever_m` allows, and booked as
  /// withheld beyond it.
  [[nodiscard]] Wrench<HapticBase> step(const Wrench<HapticBase>& asked, double share, const Exchange& exchange,
                                        double bound_N, double dt_s) noexcept;

  /// Call after the limiter. `wanted`: the limiter's input. `given`: its output.
  void limited(const Wrench<HapticBase>& given, const Wrench<HapticBase>& wanted) noexcept;

  /// True when the force of the device differs from the one that the effects and the damping ask for.
  [[nodiscard]] bool withholds() const noexcept;
  [[nodiscard]] const Force<HapticBase>& damping() const noexcept { return damping_.force; }  ///< of the last step
  [[nodiscard]] const PassivityController& passivity() const noexcept { return passivity_; }

 private:
  PassivityController passivity_;
  Wrench<HapticBase> damping_;
  Eigen::Vector3d shown_N_ = Eigen::Vector3d::Zero();  ///< the effects' force that the last tick showed
  Wrench<HapticBase> withheld_;                        ///< wrench given minus wrench asked for, over the last tick
};

}  // namespace telepalp::control
