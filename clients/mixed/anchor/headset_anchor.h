#pragma once

#include <Eigen/Geometry>
#include <span>

#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::mixed {

/// Headset (S)  the headset's own reference space: y up, against gravity; its origin and heading are arbitrary.
struct Headset {};

/// A known place of the device, touched with the tip of a tracked hand or controller.
struct Touch {
  int place = 0;            ///< number of the place; touches with equal numbers are repeats
  Point<HapticBase> known;  ///< the place on the device
  Point<Headset> touched;   ///< the tip's position at the touch
};

/// What is known of gravity.
enum class Gravity {
  Unknown,  ///< all six degrees of freedom are fitted
  Known,    ///< the device's base is level, so that y is up in both frames: heading and place are fitted
};

struct HeadsetAnchor {
  Transform<Headset, HapticBase> headset_from_haptic;
  double rms_m = 0.0;  ///< root mean square of the distances between touches and anchored places
};

/// The least-squares anchor of repeated touches at three places or more, by Kabsch on centred points. Error: fewer than
/// three places, places at one point or on a line, a number that is not finite, or an rms above 1.5 cm.
[[nodiscard]] Result<HeadsetAnchor> anchor_headset(std::span<const Touch> touches, Gravity gravity);

/// The tip of a tracked tool in the tool's frame [m], from poses in which the tip rests at one point while the tool
/// turns about it: pivot calibration. Error: fewer than four poses, or poses that turn by less than 0.2 rad.
[[nodiscard]] Result<Eigen::Vector3d> pivot_tip(std::span<const Eigen::Isometry3d> headset_from_tool);

}  // namespace telepalp::mixed
