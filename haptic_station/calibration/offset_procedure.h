#pragma once

#include <span>

#include "haptic_station/calibration/residuals.h"
#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// The hand resting on the end-effector: the same place as the tracker and as the device see it.
struct Touch {
  Point<HandTracker> hand;
  Point<HapticBase> end_effector;
};

struct OffsetCalibration {
  Transform<HapticBase, HandTracker> haptic_from_tracker;
  Residuals residuals;  ///< of each touch
};

struct OffsetSettings {
  std::size_t least_touches = 10;
  double most_moved_m = 0.005;  ///< of a touch from the mean: further, the hand was not at rest on the end-effector
};

/// S1 eq. (2) and (4): p_H = R (p_L - p0_L) + p0_H with R = diag(1, -1, -1), the offsets being the means over touches.
/// Its inverse is eq. (3), in which we read the end-effector's p0 where the paper prints its present position: only
/// so are (2) and (3) inverse to one another. The axes must be parallel as R says: the touches cannot tell.
/// Error: too few touches, numbers that are not finite or beyond 10 m, a hand that moved.
[[nodiscard]] Result<OffsetCalibration> calibrate_offset(std::span<const Touch> touches,
                                                         const OffsetSettings& settings = {});

}  // namespace telepalp::calibration
