#include "haptic_station/control/parts/transition_fade.h"

#include "haptic_station/control/safety/shortened.h"

namespace telepalp::control {

Eigen::Vector3d TransitionFade::step(const Eigen::Vector3d& raw_N, bool breaks, double rate_N_per_s,
                                     double dt_s) noexcept {
  if (breaks) fading_N_ = last_N_ - raw_N;
  const double left_N = fading_N_.norm() - rate_N_per_s * dt_s;
  fading_N_ = left_N > 0.0 ? at_most(fading_N_, left_N) : Eigen::Vector3d::Zero().eval();
  last_N_ = raw_N + fading_N_;
  return last_N_;
}

}  // namespace telepalp::control
