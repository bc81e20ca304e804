#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "proto/words/frames.h"

namespace telepalp {

/// A torque in `Frame` [N m].
template <class Frame>
struct Torque {
  Eigen::Vector3d N_m = Eigen::Vector3d::Zero();
};

/// Force on the hand at the tool's point, and torque about this point.
template <class Frame>
struct Wrench {
  Force<Frame> force{};
  Torque<Frame> torque{};
};

/// Velocity of the tool's point [m/s], and the tool's angular velocity [rad/s].
template <class Frame>
struct Twist {
  Vector<Frame> linear{};
  Vector<Frame> angular{};
};

/// What the hand holds: its point, the rotation from its axes to `Frame`, and its motion.
template <class Frame>
struct Tool {
  Point<Frame> at;
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  Twist<Frame> twist;
};

/// The rotation vector of `to` relative to `from` [rad]: `to` is `from`, turned about this axis of the outer frame by
/// its length, which is at most pi. Both must be unit quaternions.
[[nodiscard]] inline Eigen::Vector3d turned_rad(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) noexcept {
  const Eigen::Quaterniond turn = to * from.conjugate();
  const double sine = turn.vec().norm();
  if (sine < 1e-12) return Eigen::Vector3d::Zero();
  const double half_rad = std::atan2(sine, std::abs(turn.w()));
  return (turn.w() < 0.0 ? -2.0 : 2.0) * half_rad / sine * turn.vec();
}

/// `attitude`, turned by the rotation vector `turn_rad` of the outer frame.
[[nodiscard]] inline Eigen::Quaterniond turned(const Eigen::Quaterniond& attitude,
                                               const Eigen::Vector3d& turn_rad) noexcept {
  const double angle_rad = turn_rad.norm();
  if (angle_rad < 1e-12) return attitude;
  return (Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, turn_rad / angle_rad)) * attitude).normalized();
}

}  // namespace telepalp
