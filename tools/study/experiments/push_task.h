#pragma once

#include <Eigen/Core>

#include "haptic_station/device/random.h"

namespace telepalp::study {

/// The desk of paper S3 (docs/sources.md) 8.3, seen from above. The pockets lie at x = 0 (green) and x = pockets_m
/// (blue). S3 gives no lengths.
struct PushDesk {
  double pockets_m = 0.18;  ///< distance of the pockets
  double pocket_m = 0.02;   ///< radius of a pocket
  double ball_m = 0.012;    ///< radius of the ball
  double body_m = 0.045;    ///< half of the device's width where the stick crosses it in the image
  double beside_m = 0.02;   ///< distance of the device's middle from the straight way between the pockets
};

/// A simulated person who pushes a ball with a stick.
struct Pusher {
  double hand_m_per_s = 0.035;
  double reaction_s = 0.2;
  double unsteady = 0.15;      ///< SD of the hand's random velocity on each axis, as a share of its speed
  double clearance_m = 0.01;   ///< distance kept from a device that is in sight
  double heeds = 0.8;          ///< share of the detour around the device that the person makes; 0: ignores the device
  double slow_at_first = 0.3;  ///< share of its speed that the hand lacks in the first move
};

/// One move of the ball from pocket to pocket.
struct Push {
  double seconds = 0.0;
  double path_m = 0.0;  ///< length of the stick's path
  bool done = false;    ///< false: given up after kLongestPush_s
};
inline constexpr double kLongestPush_s = 60.0;

/// Positions of ball and stick.
struct Pushed {
  Eigen::Vector2d ball_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d stick_m = Eigen::Vector2d::Zero();
};

/// Pushes the ball from the pocket in which it lies to the other one, at 100 Hz. `move`: number of moves so far; the
/// person gets faster with them. `sees_device`: the person goes around the device. `at`: changed to where ball and
/// stick are at the end.
[[nodiscard]] Push push_ball(const Pusher& person, const PushDesk& desk, bool to_blue, int move, bool sees_device,
                             Pushed& at, device::Random& random) noexcept;

}  // namespace telepalp::study
