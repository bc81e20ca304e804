#include "server/capture/images/camera_file.h"

#include <cmath>
#include <sstream>

#include "messages/camera.pb.h"
#include "proto/words/error_line.h"
#include "support/program/text/text_format.h"

namespace telepalp::capture {
namespace {

constexpr double kAssumedFocalAt640 = 525.0;
constexpr std::uint16_t kAssumedFurthest_mm = 10'000;

Intrinsics intrinsics_of(const msg::CameraFile::Pinhole& pinhole) {
  return {static_cast<int>(std::min<std::uint32_t>(pinhole.width(), kMaxImageSide + 1)),
          static_cast<int>(std::min<std::uint32_t>(pinhole.height(), kMaxImageSide + 1)),
          pinhole.fx(),
          pinhole.fy(),
          pinhole.cx(),
          pinhole.cy()};
}

std::string size_text(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

Result<RecordedCamera> checked(const msg::CameraFile& file, const program::NumberPlaces& places,
                               const std::string& name, int width, int height) {
  const auto wrong = [&name](std::string what, std::string fix) {
    return Error{.what = std::move(what), .where = name, .fix = std::move(fix)};
  };
  const auto wrong_number = [&](std::string_view field, double value, std::string fix) {
    return Error{.what = std::string(field) + " is " + number_text(value),
                 .where = places.where(name, field, value),
                 .fix = std::move(fix)};
  };
  RecordedCamera camera;
  camera.model.depth = intrinsics_of(file.depth());
  camera.model.color = file.has_color() ? intrinsics_of(file.color()) : camera.model.depth;
  camera.model.color_registered = file.color_registered();
  if (!is_well_formed(camera.model.depth))
    return wrong("has no usable camera intrinsics",
                 "give depth { width: … height: … fx: … fy: … cx: … cy: … } in pixels");
  if (!is_well_formed(camera.model.color))
    return wrong(
        "has no usable intrinsics of the colour camera",
        "give color { width: … height: … fx: … fy: … cx: … cy: … } in pixels, or leave color out if the colour "
        "images have the depth camera's intrinsics");
  if (camera.model.depth.width != width || camera.model.depth.height != height)
    return wrong("is for depth images of " + size_text(camera.model.depth.width, camera.model.depth.height) +
                     " pixels, but the depth images have " + size_text(width, height),
                 "give the camera intrinsics for the size of the recorded images");
  camera.depth_unit_m = file.depth_unit_m();
  if (!(camera.depth_unit_m >= 1e-5 && camera.depth_unit_m <= 0.1))
    return wrong_number("depth_unit_m", camera.depth_unit_m,
                        "give the metres for a pixel value of 1, 0.00001 to 0.1; 0.001 for depth in millimetres");
  camera.frames_per_s = file.frames_per_s() == 0.0 ? 30.0 : file.frames_per_s();
  if (!(camera.frames_per_s >= 0.1 && camera.frames_per_s <= 1000.0))
    return wrong_number("frames_per_s", camera.frames_per_s, "give 0.1 to 1000 frames per second");
  if (file.ignore_above() > 65535)
    return wrong_number("ignore_above", file.ignore_above(), "give at most 65535, the largest value of a depth pixel");
  if (file.ignore_above() != 0) camera.ignore_above = static_cast<std::uint16_t>(file.ignore_above());
  return camera;
}

std::string text_of(const RecordedCamera& camera) {
  const Intrinsics& pinhole = camera.model.depth;
  std::ostringstream text;
  text << "depth { width: " << pinhole.width << " height: " << pinhole.height << " fx: " << pinhole.fx
       << " fy: " << pinhole.fy << " cx: " << pinhole.cx << " cy: " << pinhole.cy << " } color_registered: true"
       << " depth_unit_m: " << camera.depth_unit_m << " frames_per_s: " << camera.frames_per_s
       << " ignore_above: " << camera.ignore_above;
  return text.str();
}

}  // namespace

Result<RecordedCamera> read_camera_file(const std::filesystem::path& file, int width, int height) {
  msg::CameraFile message;
  const Result<program::NumberPlaces> read = program::read_text_format(file, message);
  if (!read) return read.error();
  return checked(message, *read, file.string(), width, height);
}

RecordedCamera assumed_camera(const std::filesystem::path& file, int width, int height) {
  const double focal = kAssumedFocalAt640 * width / 640.0;
  RecordedCamera camera;
  camera.model.depth = {width, height, focal, focal, 0.5 * (width - 1), 0.5 * (height - 1)};
  camera.model.color = camera.model.depth;
  camera.ignore_above = kAssumedFurthest_mm;
  camera.warning = "WARNING: no " + file.filename().string() +
                   ", so shape and size of the surface are guesses. fix: write the camera's own values to " +
                   file.string() + "; assumed now: " + text_of(camera);
  return camera;
}

}  // namespace telepalp::capture
