#include "tools/export_tool/image_folder.h"

#include <google/protobuf/text_format.h>

#include <cstdio>

#include "messages/camera.pb.h"
#include "support/images/image_file.h"
#include "support/program/files/whole_file.h"
#include "tools/export_tool/frames.h"

namespace telepalp::export_tool {
namespace {

namespace fs = std::filesystem;

void set_pinhole(msg::CameraFile::Pinhole& pinhole, const Intrinsics& camera) {
  pinhole.set_width(static_cast<std::uint32_t>(camera.width));
  pinhole.set_height(static_cast<std::uint32_t>(camera.height));
  pinhole.set_fx(camera.fx);
  pinhole.set_fy(camera.fy);
  pinhole.set_cx(camera.cx);
  pinhole.set_cy(camera.cy);
}

Result<void> write_camera(const fs::path& folder, const RgbdFrame& frame, double frames_per_s) {
  msg::CameraFile camera;
  set_pinhole(*camera.mutable_depth(), frame.camera.depth);
  if (!frame.color.rgb.empty()) set_pinhole(*camera.mutable_color(), frame.camera.color);
  camera.set_color_registered(frame.camera.color_registered);
  camera.set_depth_unit_m(frame.depth.unit_m);
  camera.set_frames_per_s(frames_per_s);
  std::string text;
  (void)google::protobuf::TextFormat::PrintToString(camera, &text);  // fails for missing required fields alone
  return program::write_whole_file(folder / "camera.textproto", text, program::Readers::Group);
}

Result<void> write_frame(const fs::path& out, std::uint64_t number, const RgbdFrame& frame) {
  char name[32];
  std::snprintf(name, sizeof name, "%06llu.png", static_cast<unsigned long long>(number));
  const images::GrayImage16 depth{
      .width = frame.depth.width, .height = frame.depth.height, .samples = frame.depth.samples};
  Result<void> written =
      program::write_whole_file(out / "depth" / name, images::encode_png(depth), program::Readers::Group);
  if (written && !frame.color.rgb.empty())
    written = program::write_whole_file(out / "rgb" / name, images::encode_png(frame.color), program::Readers::Group);
  return written;
}

}  // namespace

Result<Exported> write_images(const fs::path& file, const fs::path& out) {
  Result<Frames> frames = Frames::open(file);
  if (!frames) return frames.error();
  std::error_code ignored;
  const bool existed = fs::exists(out, ignored);
  if (existed && !fs::is_empty(out, ignored))
    return Error{.what = "is not an empty folder", .where = out.string(), .fix = "give a new or an empty folder"};
  Result<void> done;
  for (const fs::path& folder : {out, out / "depth", out / "rgb"})
    if (done) done = program::make_folder(folder, program::Readers::Group);
  std::optional<RgbdFrame> first;
  SessionTime last{};
  std::uint64_t count = 0;
  if (done)
    done = frames->for_each([&](const RgbdFrame& frame) -> Result<bool> {
      if (!first) first = frame;
      if (first->color.rgb.empty() != frame.color.rgb.empty()) return true;
      const Result<void> written = write_frame(out, ++count, frame);
      last = frame.captured;
      return written ? Result<bool>(true) : Result<bool>(written.error());
    });
  if (done && first) {
    const double seconds = to_seconds(last - first->captured);
    done = write_camera(out, *first, count > 1 && seconds > 0.0 ? static_cast<double>(count - 1) / seconds : 30.0);
  }
  if (done && count == 0) {
    for (const fs::path& folder : {out / "depth", out / "rgb"}) fs::remove(folder, ignored);
    if (!existed) fs::remove(out, ignored);
    return Error{
        .what = "the session holds no depth image that can be decoded, or no calibration of its depth camera",
        .where = file.string(),
        .fix = "give another session; to list the contents of this session: telepalp-record info " + file.string()};
  }
  if (!done) return done.error();
  if (first->color.rgb.empty()) fs::remove(out / "rgb", ignored);
  return Exported{.written = count, .left_out = frames->damaged()};
}

}  // namespace telepalp::export_tool
