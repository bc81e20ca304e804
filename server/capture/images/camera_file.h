#pragma once

#include <filesystem>
#include <string>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::server {

/// What must be known of a camera to play its images back.
struct RecordedCamera {
  CameraModel model;
  double depth_unit_m = 0.001;
  double frames_per_s = 30.0;
  std::uint16_t ignore_above = 65535;  ///< samples above this are "not measured"
  std::string warning;                 ///< not empty when it was assumed rather than read
};

/// Reads DIR/camera.textproto (msg.CameraFile) for depth images of the size given. An unknown field is an error with
/// line and column; a value that is missing or makes no sense names the field.
[[nodiscard]] Result<RecordedCamera> read_camera_file(const std::filesystem::path& file, int width, int height);

/// What is assumed of images without a camera file: focal length 525 pixels at a width of 640, the principal point in
/// the middle, millimetres, nothing beyond 10 m, colour registered. `warning` says so, with the text to write to
/// `file`.
[[nodiscard]] RecordedCamera assumed_camera(const std::filesystem::path& file, int width, int height);

}  // namespace telepalp::server
