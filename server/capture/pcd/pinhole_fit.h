#pragma once

#include <string>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "support/models/point_model.h"

namespace telepalp::capture {

/// Converts an organised cloud (one point per pixel, rows from top to bottom, NaN where not measured) back to an RGB-D
/// frame: fits the intrinsics to the points and stores depth in steps of 0.1 mm (1 mm when a point is 6.5 m away or
/// farther). `captured` and `sequence` are not set. `name`: the file's name, for errors. Error: an unorganised cloud,
/// fewer than 100 points, over kMaxImageSide points a side, or a misfit to a pinhole camera above 0.7 pixels (RMS).
[[nodiscard]] Result<RgbdFrame> frame_of(const models::PointModel& cloud, const std::string& name);

}  // namespace telepalp::capture
