#include "server/pipeline/camera_pipeline.h"

#include <algorithm>
#include <utility>

#include "server/pipeline/camera_messages.h"

namespace telepalp::pipeline {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kPatience = 100ms;  // longest delay of a stop or a status while no frame comes
constexpr Nanoseconds kRepeat = 1s;

/// The hand waits for its images, so they come first.
constexpr std::array kPublishingOrder{plan::Grade::Touch, plan::Grade::Full, plan::Grade::View};

}  // namespace

CameraPipeline::CameraPipeline(capture::CaptureSource& source, std::string source_name, EncodeOptions options,
                               wire::SessionClock clock, Handlers handlers)
    : source_(source),
      source_name_(std::move(source_name)),
      clock_(clock),
      handlers_(std::move(handlers)),
      stages_{stage_of(kPublishingOrder[0], options), stage_of(kPublishingOrder[1], options),
              stage_of(kPublishingOrder[2], options)},
      rate_since_(clock_.now()) {}

GradeStage CameraPipeline::stage_of(plan::Grade grade, const EncodeOptions& options) {
  return {options, clock_, [this, grade](wire::Message message) { return publish(std::move(message), grade); }};
}

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
  publish_images(frame);
}

/// Each coding of each grade is made once, and only while a subscriber takes it. Depth comes first, because the hand
/// waits for it.
void CameraPipeline::publish_images(const RgbdFrame& frame) {
  const Wanted wanted = handlers_.wanted ? handlers_.wanted() : Wanted{};
  given_up_ = wanted.given_up;
  pass_key_frame_requests_on();
  const bool predicts = !handlers_.may_predict || handlers_.may_predict();
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    stages_[i].want(wanted.made(kPublishingOrder[i]));
    if (!predicts) stages_[i].forget_depth();
    stages_[i].publish_depth(frame, frames_, wanted.window);
  }
  for (GradeStage& stage : stages_) stage.publish_color(frame, frames_);
}

/// A request names a topic, but no grade, so the next image of each grade becomes a key frame.
void CameraPipeline::pass_key_frame_requests_on() {
  const auto& take = handlers_.take_key_frame_request;
  const RequestedKeyFrames requested{.whole = take(wire::kCameraDepth.name),
                                     .window = take(wire::kCameraDepthWindow.name),
                                     .video = take(wire::kCameraColorVideo.name)};
  for (GradeStage& stage : stages_) stage.request_key_frames(requested);
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
  std::string detail = refused_.empty() ? source_.detail() : refused_;
  if (!given_up_.empty()) detail += "; " + given_up_;
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

bool CameraPipeline::publish(wire::Message message, plan::Grade grade) {
  if (message.payload->size() <= wire::kMaxPayloadBytes) return handlers_.publish(std::move(message), grade);
  refused_ = std::string(message.topic.name) + " needs " + std::to_string(message.payload->size()) +
             " B, more than the " + std::to_string(wire::kMaxPayloadBytes) +
             " B that a message may have. fix: use smaller images" +
             (message.topic.name == wire::kCameraColor.name ? ", or lower --jpeg-quality" : "");
  return false;
}

}  // namespace telepalp::pipeline
