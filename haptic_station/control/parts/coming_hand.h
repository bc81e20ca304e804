#pragma once

#include <cmath>

#include "haptic_station/control/values/control_input.h"
#include "haptic_station/control/values/encountered_settings.h"

namespace telepalp::control {

/// True if the tracked hand presses the end-effector, or is about to press it on its way towards the body: it is within
/// 5 cm sideways and 4 cm in height, and comes down or is closer than 1 cm. Such a hand leads the end-effector: lift
/// and position control then push away from the body with PositionControlSettings::against_hand_N at most. A hand
/// at 0.6 m/s needs 67 ms for these 4 cm, in which the largest force can fall to this bound without a step.
[[nodiscard]] inline bool hand_comes(const ControlInput& in) noexcept {
  constexpr double kSideways_m = 0.05;
  constexpr double kHeight_m = 0.04;
  constexpr double kAtHand_m = 0.01;  // the tracker's error
  constexpr double kDown_m_per_s = 0.05;
  if (!in.hand_valid) return false;
  const Eigen::Vector3d over_m = in.hand.m - in.device.m;
  if (std::hypot(over_m.x(), over_m.z()) > kSideways_m || std::abs(over_m.y()) > kHeight_m) return false;
  return in.hand_velocity.v.y() < -kDown_m_per_s || over_m.y() < kAtHand_m;
}

}  // namespace telepalp::control
