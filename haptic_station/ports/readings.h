#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::ports {

/// The haptic device's measurement at one tick, in the device's own frame: H unless workspace indexing shifts H.
struct DeviceReading {
  Point<HapticBase> at;
  Vector<HapticBase> velocity;  ///< [m/s]
  double age_s = 0.0;           ///< time since the device last answered
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
