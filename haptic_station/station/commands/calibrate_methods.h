#pragma once

#include "messages/calibration.pb.h"
#include "proto/words/result.h"
#include "support/program/options.h"

namespace telepalp::station {

/// One transform, measured, and where in the file it belongs.
struct Measured {
  msg::MeasuredTransform transform;
  bool of_camera = false;
};

/// By pairs of points in a file, clicked in both frames (S3 4.2).
[[nodiscard]] Result<Measured> from_points(const program::Arguments& arguments);
/// By the hand resting on the end-effector, as S1 eq. (2) to (4) ask.
[[nodiscard]] Result<Measured> from_offset(const program::Arguments& arguments);
/// By poses of a hand on a probe in a file (S2 II.C).
[[nodiscard]] Result<Measured> from_probe(const program::Arguments& arguments);

}  // namespace telepalp::station
