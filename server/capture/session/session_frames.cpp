#include "server/capture/session/session_frames.h"

#include <utility>

#include "codec/color.h"
#include "foxglove/CameraCalibration.pb.h"
#include "proto/wire/camera/calibration_message.h"
#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/depth_loss.h"
#include "proto/wire/topics.h"
#include "proto/words/counted.h"

namespace telepalp::capture {
namespace {

std::int64_t captured_ns(const msg::DepthImage& depth) { return static_cast<std::int64_t>(depth.captured_ns()); }

std::span<const std::byte> bytes_of(const std::string& data) { return std::as_bytes(std::span{data}); }

}  // namespace

Result<SessionFrames> SessionFrames::open(const std::filesystem::path& file, bool keep_compressed) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  SessionFrames frames{std::move(*reader), keep_compressed};
  if (frames.peek()) return frames;
  return Error{.what = "holds no depth images with a camera model",
               .where = file.string(),
               .fix = "give a session in which /camera/depth and /camera/info were recorded"};
}

void SessionFrames::rewind() {
  reader_.select({.topics = {std::string(wire::kCameraDepth.name), std::string(wire::kCameraColor.name),
                             std::string(wire::kCameraColorVideo.name), std::string(wire::kCameraInfo.name)}});
  color_.reset();
  gathering_.reset();
  next_.reset();
}

std::optional<SessionTime> SessionFrames::peek() {
  if (!next_) read_on();
  if (!next_) return std::nullopt;
  return session_time(captured_ns(next_->depth));
}

void SessionFrames::read_on() {
  while (!next_) {
    Result<std::optional<wire::Message>> message = reader_.next();
    if (!message) {
      ++damaged_;
      continue;  // the reader continues after the damaged chunk
    }
    if (!*message) {
      next_ = std::exchange(gathering_, std::nullopt);
      return;
    }
    note(**message);
  }
}

void SessionFrames::note(const wire::Message& message) {
  if (message.topic.name == wire::kCameraInfo.name) {
    foxglove::CameraCalibration calibration;
    if (!calibration.ParseFromString(*message.payload)) ++damaged_;
    if (const auto pinhole = wire::intrinsics_of(calibration)) pinhole_ = pinhole;
  } else if (wire::carries_color(message.topic)) {
    note_color(message);
  } else {
    Encoded encoded;
    if (!encoded.depth.ParseFromString(*message.payload)) {
      ++damaged_;
      return;
    }
    next_ = std::exchange(gathering_, std::nullopt);
    if (!pinhole_) return depth_.skip(std::move(*encoded.depth.mutable_data()));
    encoded.pinhole = *pinhole_;
    if (color_ && color_->compressed.captured_ns == captured_ns(encoded.depth))
      encoded.color = std::exchange(color_, std::nullopt);
    gathering_ = std::move(encoded);
  }
}

void SessionFrames::note_color(const wire::Message& message) {
  std::optional<wire::CompressedColor> compressed = wire::compressed_color(message);
  if (!compressed) {
    ++damaged_;
    return;
  }
  Color color{std::move(*compressed), std::nullopt};
  if (message.topic.predicted && !keep_compressed_) {
    Result<ColorImage> image =
        color_reader_.read(color.compressed.format, bytes_of(color.compressed.data), color.compressed.number);
    if (!image) {
      ++damaged_;
      return;
    }
    color.decoded = std::move(*image);
  }
  if (gathering_ && color.compressed.captured_ns == captured_ns(gathering_->depth)) {
    gathering_->color = std::move(color);
    next_ = std::exchange(gathering_, std::nullopt);
  } else {
    color_ = std::move(color);
  }
}

void SessionFrames::skip() {
  Encoded passed = std::move(*std::exchange(next_, std::nullopt));
  depth_.skip(std::move(*passed.depth.mutable_data()));
}

void SessionFrames::take_color(Color color, RgbdFrame& frame) {
  frame.camera.color_registered = color.compressed.frame_id == wire::kDepthFrameId;
  if (compressed_) {
    compressed_->color = std::move(color.compressed.data);
    compressed_->color_format = std::move(color.compressed.format);
    return;
  }
  Result<ColorImage> image = color.decoded ? Result<ColorImage>(std::move(*color.decoded))
                                           : codec::decode_color(bytes_of(color.compressed.data));
  if (image) frame.color = std::move(*image);
  if (!image) ++damaged_;
}

std::optional<RgbdFrame> SessionFrames::take() {
  Encoded encoded = std::move(*std::exchange(next_, std::nullopt));
  Result<codec::DecodedDepth> depth = depth_.read(bytes_of(encoded.depth.data()));
  if (!depth) {
    ++damaged_;
    return std::nullopt;
  }
  RgbdFrame frame;
  frame.captured = session_time(captured_ns(encoded.depth));
  frame.camera = {.depth = encoded.pinhole, .color = encoded.pinhole, .color_registered = true};
  frame.depth = std::move(depth->image);
  frame.loss = wire::loss_of(wire::depth_fidelity(encoded.depth));
  if (keep_compressed_)
    compressed_ = CompressedFrame{.depth = std::move(*encoded.depth.mutable_data()),
                                  .depth_format = encoded.depth.format(),
                                  .color = {},
                                  .color_format = {}};
  if (encoded.color) take_color(std::move(*encoded.color), frame);
  if (is_well_formed(frame)) return frame;
  ++damaged_;
  return std::nullopt;
}

std::string SessionFrames::complaint() const {
  return damaged_ == 0 ? "" : counted(damaged_, "damaged part skipped", "damaged parts skipped");
}

}  // namespace telepalp::capture
