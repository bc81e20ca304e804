#pragma once

#include "messages/calibration.pb.h"
#include "proto/words/result.h"
#include "support/program/options.h"

namespace telepalp::station {

/// One measured transform. `of_camera`: true for haptic_from_camera, false for haptic_from_tracker.
struct Measured {
  msg::MeasuredTransform transform;
  bool of_camera = false;
};

/// Measures by point pairs from a file; each point was measured in both frames (paper S3, docs/sources.md, 4.2).
[[nodiscard]] Result<Measured> from_points(const program::Arguments& arguments);
/// Measures with the hand resting on the end-effector (paper S1 eq. (2) to (4)): now, or from a file of point pairs that
/// a viewer saved.
[[nodiscard]] Result<Measured> from_offset(const program::Arguments& arguments);
/// Measures by poses of a hand on a probe, from a file (paper S2 II.C).
[[nodiscard]] Result<Measured> from_probe(const program::Arguments& arguments);

}  // namespace telepalp::station
