#include "server/pipeline/camera_messages.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "codec/color.h"
#include "codec/video.h"
#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/camera/depth_window_message.h"

namespace telepalp::pipeline {
namespace {

std::string_view color_frame_id(const RgbdFrame& frame) noexcept {
  return frame.camera.color_registered ? wire::kDepthFrameId : wire::kColorFrameId;
}

foxglove::CameraCalibration pinhole_message(const Intrinsics& k, SessionTime captured, std::string_view frame_id) {
  foxglove::CameraCalibration calibration;
  wire::set_stamp(*calibration.mutable_timestamp(), captured);
  calibration.set_frame_id(std::string(frame_id));
  calibration.set_width(static_cast<std::uint32_t>(k.width));
  calibration.set_height(static_cast<std::uint32_t>(k.height));
  calibration.set_distortion_model("plumb_bob");
  for (int i = 0; i < 5; ++i) calibration.add_d(0.0);
  for (const double value : {k.fx, 0.0, k.cx, 0.0, k.fy, k.cy, 0.0, 0.0, 1.0}) calibration.add_k(value);
  for (const double value : {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) calibration.add_r(value);
  for (const double value : {k.fx, 0.0, k.cx, 0.0, 0.0, k.fy, k.cy, 0.0, 0.0, 0.0, 1.0, 0.0}) calibration.add_p(value);
  return calibration;
}

/// The error bound of depth that may have been near-lossless before, and is coded with the bound `coded` now. The sum
/// of two such bounds has another form; twice the larger of each term is an upper bound, exact where both are equal.
std::optional<DepthErrorBound> loss_of(const RgbdFrame& frame, const std::optional<DepthErrorBound>& coded) {
  if (!coded) return frame.loss;
  const DepthErrorBound& bound = *coded;
  if (!frame.loss) return bound;
  return DepthErrorBound{.least_m = 2.0 * std::max(bound.least_m, frame.loss->least_m),
                         .per_m = 2.0 * std::max(bound.per_m, frame.loss->per_m)};
}

}  // namespace

msg::DepthImage depth_message(const RgbdFrame& frame, codec::EncodedDepth encoded) {
  msg::DepthImage image;
  image.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(frame.captured)));
  image.set_sequence(frame.sequence);
  image.set_frame_id(std::string(wire::kDepthFrameId));
  image.set_width(static_cast<std::uint32_t>(frame.depth.width));
  image.set_height(static_cast<std::uint32_t>(frame.depth.height));
  image.set_unit_m(frame.depth.unit_m);
  image.set_format(std::string(codec::name(encoded.mode)));
  if (const std::optional<DepthErrorBound> loss = loss_of(frame, encoded.bound)) {
    image.mutable_bound()->set_least_m(loss->least_m);
    image.mutable_bound()->set_per_m(loss->per_m);
  }
  if (encoded.window) *image.mutable_window() = wire::to_message(*encoded.window);
  image.set_data(std::move(encoded.bytes));
  return image;
}

foxglove::CompressedImage color_message(const RgbdFrame& frame, int jpeg_quality) {
  return color_message(frame, "jpeg", codec::encode_color(frame.color, jpeg_quality));
}

foxglove::CompressedImage color_message(const RgbdFrame& frame, const std::string& format, std::string compressed) {
  foxglove::CompressedImage image;
  wire::set_stamp(*image.mutable_timestamp(), frame.captured);
  image.set_frame_id(std::string(color_frame_id(frame)));
  image.set_format(format);
  image.set_data(std::move(compressed));
  return image;
}

foxglove::CompressedVideo video_message(const RgbdFrame& frame, std::string encoded) {
  foxglove::CompressedVideo video;
  wire::set_stamp(*video.mutable_timestamp(), frame.captured);
  video.set_frame_id(std::string(color_frame_id(frame)));
  video.set_format(codec::kVideoFormat);
  video.set_data(std::move(encoded));
  return video;
}

foxglove::CameraCalibration calibration_message(const RgbdFrame& frame) {
  return pinhole_message(frame.camera.depth, frame.captured, wire::kDepthFrameId);
}

foxglove::CameraCalibration color_calibration_message(const RgbdFrame& frame) {
  return pinhole_message(frame.camera.color, frame.captured, color_frame_id(frame));
}

msg::CaptureState to_message(capture::CaptureState state) noexcept {
  switch (state) {
    case capture::CaptureState::Waiting:
      return msg::CAPTURE_STATE_WAITING;
    case capture::CaptureState::Live:
      return msg::CAPTURE_STATE_LIVE;
    case capture::CaptureState::Lost:
      return msg::CAPTURE_STATE_LOST;
    case capture::CaptureState::Ended:
      return msg::CAPTURE_STATE_ENDED;
  }
  return msg::CAPTURE_STATE_UNSPECIFIED;
}

}  // namespace telepalp::pipeline
