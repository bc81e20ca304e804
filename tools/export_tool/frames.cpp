#include "tools/export_tool/frames.h"

#include <algorithm>

#include "codec/color.h"
#include "foxglove/CameraCalibration.pb.h"
#include "messages/camera.pb.h"
#include "proto/wire/camera/calibration_message.h"
#include "proto/wire/camera/camera_stamp.h"
#include "proto/words/counted.h"

namespace telepalp::export_tool {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kLookBack_ns = 10 * kSecond_ns;  // a key frame and a camera model come at least this often

std::vector<std::string> camera_topics() {
  return {std::string(wire::kCameraInfo.name), std::string(wire::kCameraDepth.name),
          std::string(wire::kCameraColor.name), std::string(wire::kCameraColorVideo.name),
          std::string(wire::kCameraColorInfo.name)};
}

Error no_frame(const std::string& what) {
  return {.what = what,
          .where = "/camera/depth",
          .fix = "give another time or session; telepalp-record info FILE shows what a session holds"};
}

}  // namespace

std::string left_out_in_words(std::uint64_t left_out, const std::string& session) {
  if (left_out == 0) return {};
  return counted(left_out, "damaged message or part", "damaged messages or parts") + " of " + session +
         (left_out == 1 ? " is" : " are") + " left out. fix: telepalp-record verify " + session + " names the damage";
}

Result<Frames> Frames::open(const std::filesystem::path& file) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  return Frames(std::move(*reader));
}

std::optional<wire::Message> Frames::next() {
  for (;;) {
    Result<std::optional<wire::Message>> message = reader_.next();
    if (message) return std::move(*message);
    ++damaged_;  // the reader continues after the damaged chunk
  }
}

/// Takes in a camera's model or a colour image.
void Frames::note(const wire::Message& message) {
  if (wire::carries_color(message.topic)) return note_color(message);
  const bool is_color = message.topic.name == wire::kCameraColorInfo.name;
  foxglove::CameraCalibration model;
  if (!is_color && message.topic.name != wire::kCameraInfo.name) return;
  if (!model.ParseFromString(*message.payload)) ++damaged_;
  if (const auto pinhole = wire::intrinsics_of(model)) (is_color ? color_pinhole_ : pinhole_) = pinhole;
}

void Frames::note_color(const wire::Message& message) {
  std::optional<wire::CompressedColor> compressed = wire::compressed_color(message);
  if (!compressed) {
    ++damaged_;
    return;
  }
  Color color{std::move(*compressed), std::nullopt};
  if (message.topic.predicted) {
    Result<ColorImage> image = color_reader_.read(
        color.compressed.format, std::as_bytes(std::span(color.compressed.data)), color.compressed.number);
    if (!image) {
      ++damaged_;
      return;
    }
    color.decoded = std::move(*image);
  }
  if (waiting_ && color.compressed.captured_ns == waiting_->captured_ns)
    waiting_->color = std::move(color);
  else
    color_ = std::move(color);
}

/// Takes in a depth image, which then waits for its colour.
void Frames::take_depth(const wire::Message& message) {
  msg::DepthImage image;
  if (message.topic.name != wire::kCameraDepth.name) return;
  if (!image.ParseFromString(*message.payload)) {
    ++damaged_;
    return;
  }
  if (waiting_) depth_.skip(std::move(waiting_->packet));
  waiting_ = Waiting{std::move(*image.mutable_data()), static_cast<std::int64_t>(image.captured_ns()), {}};
  if (color_ && color_->compressed.captured_ns == waiting_->captured_ns)
    waiting_->color = std::exchange(color_, std::nullopt);
}

Result<RgbdFrame> Frames::decode(const Waiting& waiting) {
  Result<codec::DecodedDepth> depth = depth_.read(std::as_bytes(std::span(waiting.packet)));
  if (!depth) return no_frame("the depth image cannot be decoded: " + depth.error().what);
  if (!pinhole_)
    return no_frame("no calibration of the camera (/camera/info) was recorded in the 10 s before the given time");
  RgbdFrame frame;
  frame.captured = session_time(waiting.captured_ns);
  frame.camera = {.depth = *pinhole_, .color = *pinhole_, .color_registered = true};
  frame.depth = std::move(depth->image);
  if (waiting.color) {
    Result<ColorImage> color = waiting.color->decoded
                                   ? Result<ColorImage>(*waiting.color->decoded)
                                   : codec::decode_color(std::as_bytes(std::span(waiting.color->compressed.data)));
    if (!color) ++damaged_;
    if (color) frame.color = std::move(*color);
    frame.camera.color_registered = waiting.color->compressed.frame_id == wire::kDepthFrameId;
    if (!frame.camera.color_registered) frame.camera.color = color_pinhole_.value_or(*pinhole_);
  }
  if (!is_well_formed(frame))
    return no_frame(
        "the calibration of the depth camera (/camera/info) is invalid, or is for images of another width or height");
  return frame;
}

Result<void> Frames::for_each(const std::function<Result<bool>(const RgbdFrame&)>& take) {
  reader_.select({.topics = camera_topics()});
  const auto finish = [&]() -> Result<bool> {
    if (!waiting_) return true;
    const Result<RgbdFrame> frame = decode(*std::exchange(waiting_, std::nullopt));
    if (frame) return take(*frame);
    ++damaged_;
    return true;
  };
  for (;;) {
    const std::optional<wire::Message> message = next();
    if (!message || message->topic.name == wire::kCameraDepth.name)
      if (const Result<bool> more = finish(); !more || !*more)
        return more ? Result<void>{} : Result<void>(more.error());
    if (!message) return {};
    note(*message);
    take_depth(*message);
  }
}

Result<RgbdFrame> Frames::at(double at_s) {
  const auto begin = static_cast<std::int64_t>(reader_.summary().statistics.message_start_time);
  const std::int64_t asked = begin + static_cast<std::int64_t>(at_s * 1e9);
  const SessionTime from = session_time(std::max(begin, asked - kLookBack_ns));
  const auto video_key = reader_.last_key_frame(wire::kCameraColorVideo, session_time(asked));
  reader_.select({.topics = camera_topics(),
                  .from = std::min(from, video_key.value_or(from)),
                  .until = session_time(asked + kSecond_ns)});
  while (const std::optional<wire::Message> message = next()) {
    const bool is_depth = message->topic.name == wire::kCameraDepth.name;
    if (is_depth && to_nanoseconds(message->published) > asked) break;
    note(*message);
    take_depth(*message);
  }
  if (!waiting_) return no_frame("no depth image was published in the 10 s before the given time");
  return decode(*std::exchange(waiting_, std::nullopt));
}

}  // namespace telepalp::export_tool
