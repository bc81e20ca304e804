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

// The checks of the methods' options. They open no file and no device; an error means a wrong command line.
[[nodiscard]] Result<void> check_points(const program::Arguments& arguments);
[[nodiscard]] Result<void> check_offset(const program::Arguments& arguments);
[[nodiscard]] Result<void> check_probe(const program::Arguments& arguments);

// The methods. Each one needs options that its check has accepted.

/// Measures either transform from a file of points measured in both of its frames (paper S3, docs/sources.md, 4.2).
[[nodiscard]] Result<Measured> from_points(const program::Arguments& arguments);
/// Measures haptic_from_tracker with the hand resting on the end-effector (paper S1 eq. (2) to (4)): with the device
/// and tracker that `arguments` names, or from a file of point pairs that a viewer saved.
[[nodiscard]] Result<Measured> from_offset(const program::Arguments& arguments);
/// Measures haptic_from_tracker from a file of poses of a hand that rests on a probe (paper S2 II.C).
[[nodiscard]] Result<Measured> from_probe(const program::Arguments& arguments);

}  // namespace telepalp::station
