#pragma once

#include <string>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "support/models/point_model.h"

namespace telepalp::server {

/// An organised cloud (one point a pixel, rows top to bottom; not finite: not measured) as the image that it came from:
/// intrinsics fitted to where the points lie, depth in steps of 0.1 mm (1 mm when some point is further than 6.5 m).
/// `captured` and `sequence` are not set. Refused: a cloud that is not organised, and points that no pinhole camera put
/// on the pixels that they stand for (RMS beyond 0.7 pixel). `name` stands for the file in errors.
[[nodiscard]] Result<RgbdFrame> frame_of(const models::PointModel& cloud, const std::string& name);

}  // namespace telepalp::server
