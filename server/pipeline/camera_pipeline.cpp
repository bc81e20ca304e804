#include "server/pipeline/camera_pipeline.h"

#include <algorithm>
#include <utility>

#include "proto/link/datagram_link.h"
#include "server/pipeline/camera_messages.h"

namespace telepalp::pipeline {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kPatience = 100ms;  // longest delay of a stop or a status while no frame comes
constexpr Nanoseconds kRepeat = 1s;

/// About 0.6 and 0.35 of the bytes at the default of 85.
constexpr int kSmallerColour = 60;
constexpr int kSmallestColour = 25;

/// The rate of colour as video at a level above 0: 60 % of `kbit_per_s` at level 1, 35 % from level 2 on.
int shrunk_rate(int kbit_per_s, std::size_t level) { return std::max(1, kbit_per_s * (level == 1 ? 60 : 35) / 100); }

}  // namespace

EncodeOptions shrunk(EncodeOptions asked, std::size_t level) noexcept {
  if (level == 0) return asked;
  if (asked.depth.mode == codec::DepthMode::Fast) asked.depth.mode = codec::DepthMode::Intra;
  asked.jpeg_quality = std::min(asked.jpeg_quality, level == 1 ? kSmallerColour : kSmallestColour);
  asked.video_kbit_per_s = shrunk_rate(asked.video_kbit_per_s, level);
  if (level == 1) return asked;
  asked.depth.bound.least_m *= 2.0;
  asked.depth.bound.per_m *= 2.0;
  return asked;
}

CameraPipeline::CameraPipeline(capture::CaptureSource& source, std::string source_name, EncodeOptions options,
                               wire::SessionClock clock, Handlers handlers)
    : source_(source),
      source_name_(std::move(source_name)),
      asked_(options),
      options_(options),
      clock_(clock),
      handlers_(std::move(handlers)),
      video_(options.video_kbit_per_s),
      window_(options.depth),
      rate_since_(clock_.now()) {}

bool CameraPipeline::step() {
  const std::optional<RgbdFrame> frame = source_.next(kPatience);
  if (frame) publish_frame(*frame);
  publish_status_when_due();
  return frame || source_.state() != capture::CaptureState::Ended;
}

void CameraPipeline::publish_frame(const RgbdFrame& frame) {
  ++frames_;
  refused_ = is_well_formed(frame) ? ""
                                   : "the image sizes or intrinsics of a frame contradict each other, so the frame is "
                                     "not sent. fix: check the camera and its driver, or the recording";
  if (!refused_.empty()) return;
  color_registered_ = frame.camera.color_registered;
  publish_calibration_when_due(frame);
  shrink_when_asked();
  if (link::ContentLevel::leaves_out(level_, frames_)) return;
  const Wanted wanted = handlers_.wanted ? handlers_.wanted() : Wanted{};
  publish_depth(frame, wanted);
  publish_color(frame, wanted.color);
}

/// Each coding is made once, and only while a subscriber takes it.
void CameraPipeline::publish_color(const RgbdFrame& frame, ColorWanted wanted) {
  if (!wanted.video) video_.end();
  if (frame.color.rgb.empty()) return;
  if (wanted.video) publish_video(frame);
  if (!wanted.makes_pictures()) return;
  const foxglove::CompressedImage color = color_message(frame, options_.jpeg_quality);
  publish(wire::make_message(wire::kCameraColor, clock_.now(), color));
}

void CameraPipeline::publish_video(const RgbdFrame& frame) {
  if (handlers_.take_key_frame_request(wire::kCameraColorVideo.name)) video_.request_key_frame();
  std::optional<codec::EncodedVideo> encoded = video_.encode(frame);
  if (!encoded) return;
  const bool is_key = encoded->key_frame;
  const foxglove::CompressedVideo color = video_message(frame, std::move(encoded->bytes));
  if (!publish(wire::make_message(wire::kCameraColorVideo, clock_.now(), color, is_key))) video_.lost_frame();
}

void CameraPipeline::shrink_when_asked() {
  const std::size_t level = handlers_.content_level ? handlers_.content_level() : 0;
  if (std::exchange(level_, level) == level) return;
  options_ = shrunk(asked_, level);
  whole_.end();
  video_.set_rate(options_.video_kbit_per_s);
}

/// As for colour, each coding is made once, and only while a subscriber takes it.
void CameraPipeline::publish_depth(const RgbdFrame& frame, const Wanted& wanted) {
  if (!wanted.depth.window) window_.end();
  if (!wanted.depth.makes_whole()) whole_.end();
  if (wanted.depth.window) publish_window(frame, wanted.window);  // first: the hand waits for it
  if (wanted.depth.makes_whole()) publish_whole(frame);
}

void CameraPipeline::publish_whole(const RgbdFrame& frame) {
  if (handlers_.take_key_frame_request(wire::kCameraDepth.name)) whole_.request_key_frame();
  if (must_not_predict()) whole_.lost_frame();
  codec::EncodedDepth coded = whole_.encode_paced(options_.depth, frame.depth);
  if (!publish_depth_as(wire::kCameraDepth, frame, std::move(coded))) whole_.lost_frame();
}

void CameraPipeline::publish_window(const RgbdFrame& frame, const std::optional<DepthWindow>& window) {
  if (handlers_.take_key_frame_request(wire::kCameraDepthWindow.name)) window_.request_key_frame();
  if (must_not_predict()) window_.lost_frame();
  codec::EncodedDepth coded = window_.encode(frame, window);
  if (!publish_depth_as(wire::kCameraDepthWindow, frame, std::move(coded))) window_.lost_frame();
}

bool CameraPipeline::must_not_predict() const { return handlers_.may_predict && !handlers_.may_predict(); }

/// False: the message was dropped. A dropped frame cannot be a reference, so the next one must be a key frame.
bool CameraPipeline::publish_depth_as(const wire::Topic& topic, const RgbdFrame& frame, codec::EncodedDepth coded) {
  const bool is_key = coded.key_frame;
  msg::DepthImage depth = depth_message(frame, std::move(coded));
  const SessionTime encoded = clock_.now();
  depth.set_encoded_ns(static_cast<std::uint64_t>(to_nanoseconds(encoded)));
  return publish(wire::make_message(topic, encoded, depth, is_key));
}

void CameraPipeline::publish_calibration_when_due(const RgbdFrame& frame) {
  const SessionTime now = clock_.now();
  const bool same = calibration_ && calibration_->depth == frame.camera.depth &&
                    calibration_->color == frame.camera.color &&
                    calibration_->color_registered == frame.camera.color_registered;
  if (same && now - calibration_at_ < kRepeat) return;
  calibration_ = frame.camera;
  calibration_at_ = now;
  publish(wire::make_message(wire::kCameraInfo, now, calibration_message(frame)));
  if (!frame.color.rgb.empty())
    publish(wire::make_message(wire::kCameraColorInfo, now, color_calibration_message(frame)));
}

void CameraPipeline::publish_status_when_due() {
  const SessionTime now = clock_.now();
  const capture::CaptureState state = source_.state();
  const std::string detail = refused_.empty() ? source_.detail() : refused_;
  measure_rate(now);
  if (state_ == state && detail_ == detail && now - status_at_ < kRepeat) return;
  msg::CaptureStatus status;
  status.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(now)));
  status.set_state(to_message(state));
  status.set_source(source_name_);
  status.set_detail(detail);
  status.set_frames(frames_);
  status.set_frames_per_s(frames_per_s_);
  status.set_color_registered(color_registered_);
  state_ = state;
  detail_ = detail;
  status_at_ = now;
  publish(wire::make_message(wire::kCameraStatus, now, status));
}

void CameraPipeline::measure_rate(SessionTime now) {
  const Nanoseconds window = now - rate_since_;
  if (window < kRepeat) return;
  frames_per_s_ = static_cast<double>(frames_ - frames_at_rate_) / to_seconds(window);
  rate_since_ = now;
  frames_at_rate_ = frames_;
}

bool CameraPipeline::publish(wire::Message message) {
  if (message.payload->size() <= wire::kMaxPayloadBytes) return handlers_.publish(std::move(message));
  refused_ = std::string(message.topic.name) + " needs " + std::to_string(message.payload->size()) +
             " B, more than the " + std::to_string(wire::kMaxPayloadBytes) +
             " B that a message may have. fix: use smaller images" +
             (message.topic.name == wire::kCameraColor.name ? ", or lower --jpeg-quality" : "");
  return false;
}

}  // namespace telepalp::pipeline
