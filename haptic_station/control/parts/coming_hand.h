#pragma once

#include <algorithm>
#include <cmath>

#include "haptic_station/control/values/control_input.h"
#include "haptic_station/control/values/encountered_settings.h"

namespace telepalp::control {

inline constexpr double kComesDown_m_per_s = 0.05;

/// True if the tracked hand presses the end-effector, or is about to press it on its way towards the body: it is within
/// 5 cm sideways and 4 cm in height, and comes down or is less than 1 cm above the end-effector. Such a hand leads the
/// end-effector: lift and position control then push away from the body with PositionControlSettings::against_hand_N at
/// most. A hand at 0.6 m/s needs 67 ms for these 4 cm, in which the largest force can fall to this bound without a
/// step.
[[nodiscard]] inline bool hand_comes(const ControlInput& in) noexcept {
  constexpr double kSideways_m = 0.05;
  constexpr double kHeight_m = 0.04;
  constexpr double kAtHand_m = 0.01;                 // the tracker's error
  if (!in.hand_valid || in.wait_at_m) return false;  // a pointer that hovers in a browser is not at the end-effector
  const Eigen::Vector3d over_m = in.hand.m - in.device.m;
  if (std::hypot(over_m.x(), over_m.z()) > kSideways_m || std::abs(over_m.y()) > kHeight_m) return false;
  return in.hand_velocity.v.y() < -kComesDown_m_per_s || over_m.y() < kAtHand_m;
}

/// `force_N` with at most `most_N` upwards and out of the body, and at most `most_N` against the movement of the hand
/// and of an end-effector that the hand pushes down. On a flank, both also move sideways on their way down. The
/// end-effector's own movement counts because the hand's is known late, by the delay of the tracker.
[[nodiscard]] inline Eigen::Vector3d yielding(const ControlInput& in, Eigen::Vector3d force_N, double most_N) noexcept {
  force_N.y() = std::min(force_N.y(), most_N);
  const auto yield_to = [&](const Eigen::Vector3d& direction) {
    const Eigen::Vector3d way = direction.stableNormalized();
    force_N += std::max(0.0, -force_N.dot(way) - most_N) * way;
  };
  if (in.contact.valid) yield_to(-in.contact.normal.v);
  yield_to(in.hand_velocity.v);
  if (in.device_velocity.v.y() < -kComesDown_m_per_s) yield_to(in.device_velocity.v);
  return force_N;
}

}  // namespace telepalp::control
