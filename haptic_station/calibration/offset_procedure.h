#pragma once

#include <span>

#include "haptic_station/calibration/residuals.h"
#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// One measurement with the hand resting on the end-effector: the same place in the tracker's and in the device's
/// frame.
struct Touch {
  Point<HandTracker> hand;
  Point<HapticBase> end_effector;
};

struct OffsetCalibration {
  Transform<HapticBase, HandTracker> haptic_from_tracker;
  Residuals residuals;  ///< one for each touch
};

struct OffsetSettings {
  std::size_t least_touches = 10;
};

/// Paper S1 (docs/sources.md) eq. (2) and (4): p_H = R (p_L - p0_L) + p0_H with R = diag(1, -1, -1). H is the haptic
/// base's frame, L the tracker's; p0_L and p0_H are the mean hand and end-effector positions over the touches. S1's eq.
/// (3) is the inverse of eq. (2) only if its symbol for the present position of the end-effector means p0_H; this code
/// assumes so. R must hold for the mounted tracker: touches at one place cannot detect another rotation. Error: too few
/// touches, a number that is not finite or beyond 10 m, or a hand that moved on the end-effector.
[[nodiscard]] Result<OffsetCalibration> calibrate_offset(std::span<const Touch> touches,
                                                         const OffsetSettings& settings = {});

}  // namespace telepalp::calibration
