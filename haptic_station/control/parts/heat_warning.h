#pragma once

#include <Eigen/Core>

#include "haptic_station/control/safety/force_limiter.h"

namespace telepalp::control {

/// Announces at the hand, seconds before, that warm motors will lower the force: a faint vibration along the force.
/// Owner: control thread.
class HeatWarning {
 public:
  /// The vibration to add to `force_N` for the next tick [N]; zero while the force can be held for long enough.
  [[nodiscard]] Eigen::Vector3d step(const Eigen::Vector3d& force_N, const ForceLimiter& limiter, double dt_s) noexcept;

  /// Time until the force of the last step is lowered, if it is held [s]; infinite when it never is.
  [[nodiscard]] double yields_in_s() const noexcept { return yields_in_s_; }

 private:
  double yields_in_s_ = 0.0;
  double smooth_N_ = 0.0;     ///< the force without its own vibration and the hand's tremor
  double amplitude_N_ = 0.0;  ///< rises and falls without a step
  double turns_ = 0.0;        ///< of the vibration, 0 to 1
};

}  // namespace telepalp::control
