#pragma once

#include <Eigen/Core>

#include "haptic_station/device/random.h"

namespace telepalp::study {

/// The desk of paper S3 (docs/sources.md) 8.3, seen from above. The pockets lie at x = 0 (green) and x = pockets_m
/// (blue). S3 gives no lengths.
struct Desk {
  double pockets_m = 0.18;  ///< distance of the pockets
  double pocket_m = 0.02;   ///< radius of a pocket
  double ball_m = 0.012;    ///< radius of the ball
  double body_m = 0.045;    ///< half of the width of the device, where the stick crosses it in the image
  double beside_m = 0.02;   ///< distance of the body's middle from the straight way between the pockets
};

/// A simulated person who pushes a ball with a stick.
struct Pusher {
  double hand_m_per_s = 0.035;
  double reaction_s = 0.2;
  double unsteady = 0.15;      ///< SD of the hand's sideways velocity, as a share of its speed
  double clearance_m = 0.01;   ///< distance kept from a device that is in sight
  double heeds = 0.8;          ///< share of that detour which the person really makes; 0: ignores the device
  double slow_at_first = 0.3;  ///< by this share the first move is slower
};

/// One move of the ball from pocket to pocket.
struct Push {
  double seconds = 0.0;
  double path_m = 0.0;  ///< length of the stick's way
  bool done = false;    ///< false: given up after kLongestPush_s
};
inline constexpr double kLongestPush_s = 60.0;

/// Where ball and stick are.
struct Pushed {
  Eigen::Vector2d ball_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d stick_m = Eigen::Vector2d::Zero();
};

/// Pushes the ball from the pocket in which it lies to the other one, at 100 Hz. `move`: number of moves so far, from
/// which the person gets faster. `sees_device`: the person goes around the device. `at`: in and out. Pure.
[[nodiscard]] Push push_ball(const Pusher& person, const Desk& desk, bool to_blue, int move, bool sees_device,
                             Pushed& at, device::Random& random) noexcept;

/// The shortest way from pocket to pocket that stays `clear_m` away from the device's middle [m].
[[nodiscard]] double shortest_way_m(const Desk& desk, double clear_m) noexcept;

}  // namespace telepalp::study
