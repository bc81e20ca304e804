#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <optional>

#include "proto/words/frames.h"
#include "proto/words/time.h"
#include "proto/words/wrench.h"

namespace telepalp::ports {

/// The greatest force and torque that a device can give. The device states them with each reading, because a program
/// that serves a device may be started again with another one.
struct DevicePower {
  double most_N = std::numeric_limits<double>::infinity();  ///< infinite: not stated; the scene's limit counts
  double most_N_m = 0.0;                                    ///< 0: the device gives forces alone
};

/// The haptic device's measurement at one tick, in the device's own frame: H unless workspace indexing shifts H.
struct DeviceReading {
  Point<HapticBase> at;
  Vector<HapticBase> velocity;  ///< [m/s]
  double age_s = 0.0;           ///< time since the device last answered
  /// Rotation from the tool's axes to the device's frame; nullopt: the device does not measure it. At the identity, the
  /// tool's axes are those of the frame, and a needle points down, along -y.
  std::optional<Eigen::Quaterniond> attitude = {};
  Vector<HapticBase> turning = {};  ///< angular velocity [rad/s]; counts only with `attitude`
  bool pressed = false;             ///< the hand presses the device's button; false: it has none
  DevicePower power = {};
  /// Age of this reading plus age of the newest command that the device had received before it: the time since the
  /// station gave that command. nullopt: the device does not tell which command it has received.
  std::optional<double> loop_s = {};
};

/// One sample of the hand tracker, in the frame of DeviceReading, stamped with the time at which it saw the hand.
struct HandSample {
  SessionTime at;
  Point<HapticBase> hand;
  /// Rotation from the hand's axes (tracking/hand_axes.h) to the haptic base's frame; nullopt: the tracker does not
  /// measure it.
  std::optional<Eigen::Quaterniond> attitude = {};
  /// Height y at which the free end-effector waits under this hand [m]; nullopt: the scene's plane decides.
  std::optional<double> wait_at_m = {};
};

}  // namespace telepalp::ports
