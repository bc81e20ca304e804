#pragma once

#include "haptic_station/control/safety/passivity.h"

namespace telepalp::control {

/// Books the energy that passes between the effects and the hand when the device cannot give all the force that the
/// effects ask for, and adds the passivity controller's damping. Owner: control thread.
class EnergyAccount {
 public:
  /// Contact begins with no energy stored.
  void begin() noexcept;

  /// The force to show for the next tick [N], damping included. `asked_N`: of the effects. `share`: of it that is
  /// shown, 1 but for a contact that is being released. `exchange`: what passed between the effects and the hand over
  /// the last tick. `bound_N`: the most that the limiter lets through now.
  [[nodiscard]] Eigen::Vector3d step(const Eigen::Vector3d& asked_N, double share, const Exchange& exchange,
                                     double bound_N, double dt_s) noexcept;

  /// The limiter gave `given_N` where `wanted_N` was wanted.
  void limited(const Eigen::Vector3d& given_N, const Eigen::Vector3d& wanted_N) noexcept;

  /// True when the device gives another force than the effects ask for.
  [[nodiscard]] bool withholds() const noexcept;
  [[nodiscard]] const Force<HapticBase>& damping() const noexcept { return damping_; }  ///< of the last step
  [[nodiscard]] const PassivityController& passivity() const noexcept { return passivity_; }

 private:
  PassivityController passivity_;
  Force<HapticBase> damping_;
  Eigen::Vector3d withheld_N_ = Eigen::Vector3d::Zero();  ///< given less asked, over the tick that ends
};

}  // namespace telepalp::control
