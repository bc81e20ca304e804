#pragma once

#include <Eigen/Core>

#include "haptic_station/control/safety/force_limiter.h"
#include "proto/words/last_result.h"

namespace telepalp::control {

/// Warns the hand 4 s before ForceLimiter lowers the force to protect the motors from heat. The warning is a faint
/// vibration along the force. Owner: haptic thread.
class HeatWarning {
 public:
  /// The vibration to add to the contact force `force_N` for the next tick [N]. Its amplitude rises gradually while
  /// yields_in_s() is below 4 s, and else falls to zero.
  [[nodiscard]] Eigen::Vector3d step(const Eigen::Vector3d& force_N, const ForceLimiter& limiter, double dt_s) noexcept;

  /// Time until the limiter would lower the low-pass filtered contact force if it stayed constant [s]; infinite: never.
  [[nodiscard]] double yields_in_s() const noexcept { return yields_in_s_; }

 private:
  double yields_in_s_ = 0.0;
  double smooth_N_ = 0.0;     ///< low-pass filtered force, without the vibration and the hand's tremor
  double amplitude_N_ = 0.0;  ///< amplitude of the vibration; it changes gradually
  double turns_ = 0.0;        ///< phase of the vibration in turns, 0 to 1
  LastExp smooth_left_;       ///< weight of the older forces in smooth_N_ after a tick
};

}  // namespace telepalp::control
