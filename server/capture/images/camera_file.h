#pragma once

#include <filesystem>
#include <string>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::capture {

/// Camera parameters that the playback of image files needs.
struct RecordedCamera {
  CameraModel model;
  double depth_unit_m = 0.001;
  double frames_per_s = 30.0;
  std::uint16_t ignore_above = 65535;  ///< samples above this count as "not measured"
  std::string warning;                 ///< not empty when the parameters are assumed
};

/// Reads the camera file `file` (text format of msg.CameraFile) of depth images of `width` x `height` pixels. Error: an
/// unknown field, reported with line and column, or a missing or invalid value, reported with the field's name.
[[nodiscard]] Result<RecordedCamera> read_camera_file(const std::filesystem::path& file, int width, int height);

/// Assumed parameters of images without a camera file: focal length 525/640 of the width, principal point at the
/// centre, unit 1 mm, depths above 10 m ignored, colour registered to depth. `warning` states these values as the
/// text of a camera file, and asks for the camera's own values in `file`.
[[nodiscard]] RecordedCamera assumed_camera(const std::filesystem::path& file, int width, int height);

}  // namespace telepalp::capture
