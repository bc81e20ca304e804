#include "haptic_station/core/surface_stage.h"

#include <algorithm>
#include <utility>

#include "haptic_station/core/stamp.h"
#include "haptic_station/core/window/hand_window.h"
#include "proto/wire/camera/depth_window_message.h"

namespace telepalp::core {
namespace {

// Ten seconds of a 30 Hz stream with 100 kB a frame. A message that is dropped before it is decoded breaks the chain of
// predicted frames until the next key frame, so all messages wait, as far as memory allows.
constexpr int kMostWaiting = 300;
constexpr std::size_t kMostWaitingBytes = 32U << 20U;

// The session clock steps by at least this. Smaller corrections are slewed, so it never runs back in between
// (proto/wire/clock_sync.h).
constexpr Nanoseconds kClockStep = std::chrono::seconds(1);

constexpr const char* kSameVersion = "install the same version of telepalp at server and station";

std::string topic_of(const ArrivedDepth& depth) { return std::string(depth.depth.topic.name); }

std::string image_of(const ArrivedDepth& depth, const msg::DepthImage& message) {
  return topic_of(depth) + ", image " + std::to_string(message.sequence());
}

Error not_a_depth_image(const ArrivedDepth& arrived) {
  return {.what = "the message is not a depth image", .where = topic_of(arrived), .fix = kSameVersion};
}

Error other_size(const ArrivedDepth& arrived, const msg::DepthImage& message) {
  return {.what = "the image's size is not the one that its message declares",
          .where = image_of(arrived, message),
          .fix = kSameVersion};
}

Error other_camera(const ArrivedDepth& arrived, const DepthImage& depth) {
  const Intrinsics& camera = arrived.camera;
  return {.what = "the image is " + std::to_string(depth.width) + " x " + std::to_string(depth.height) +
                  " pixels, its camera model is for " + std::to_string(camera.width) + " x " +
                  std::to_string(camera.height),
          .where = topic_of(arrived),
          .fix = "correct camera.textproto at the server"};
}

Error not_measured(const ArrivedDepth& arrived, const msg::DepthImage& message) {
  return {.what = "fewer than half of the pixels around the image's centre, where the patient should be, are measured",
          .where = image_of(arrived, message),
          .fix = "aim the camera at the patient, from a distance at which it measures"};
}

Error not_newer(const ArrivedDepth& arrived, const msg::DepthImage& message) {
  return {.what = "the image is not newer than the last one, or its size or camera model is invalid",
          .where = image_of(arrived, message),
          .fix = "check the camera's time stamps, and camera.textproto at the server"};
}

/// The report of a surface; judge() adds what the choice of the setting knows.
msg::SurfaceReport report_of(const msg::DepthImage& message, codec::DepthMode mode, SessionTime received,
                             SessionTime decoded, SessionTime touchable, const surface::SurfaceSnapshot& snapshot) {
  msg::SurfaceReport report;
  report.set_captured_ns(message.captured_ns());
  report.set_encoded_ns(message.encoded_ns());
  report.set_received_ns(stamp(received));
  report.set_decoded_ns(stamp(decoded));
  report.set_touchable_ns(stamp(touchable));
  report.set_sequence(message.sequence());
  report.set_points(snapshot.points);
  report.set_index(snapshot.index_name);
  report.set_depth_mode(std::string(codec::name(mode)));
  if (message.has_bound()) *report.mutable_depth_bound() = message.bound();
  return report;
}

}  // namespace

ArrivedDepth seen_image(DepthImage image, const Intrinsics& camera, SessionTime captured, std::uint64_t sequence,
                        SessionTime received) {
  msg::DepthImage message;
  message.set_captured_ns(stamp(captured));
  message.set_encoded_ns(stamp(captured));
  message.set_sequence(sequence);
  message.set_width(static_cast<std::uint32_t>(image.width));
  message.set_height(static_cast<std::uint32_t>(image.height));
  message.set_unit_m(image.unit_m);
  return {.depth = wire::make_message(wire::kCameraDepth, captured, message, true),
          .camera = camera,
          .received = received,
          .decoded = std::make_shared<const DepthImage>(std::move(image))};
}

SurfaceStage::SurfaceStage(const surface::SurfaceSettings& settings, Placement placement,
                           const effects::EffectBank& effects, OnImage on_image)
    : choice_(settings),
      builder_(settings),
      placement_(std::move(placement)),
      effects_(effects),
      on_image_(std::move(on_image)) {}

bool SurfaceStage::admit(std::size_t bytes) noexcept {
  ++offered_;
  if (admitted_ >= kMostWaiting || admitted_bytes_ + bytes > kMostWaitingBytes) return false;
  ++admitted_;
  admitted_bytes_ += bytes;
  return true;
}

void SurfaceStage::arrived(ArrivedDepth message) { waiting_.push_back(std::move(message)); }

std::optional<SurfaceStage::Job> SurfaceStage::take(SessionTime now, const std::optional<Point<HapticBase>>& device) {
  if (waiting_.empty()) return std::nullopt;
  Job job{.messages = {std::make_move_iterator(waiting_.begin()), std::make_move_iterator(waiting_.end())},
          .device = device,
          .begun = now,
          .accept_object = std::exchange(accept_object_, false)};
  waiting_.clear();
  for (const ArrivedDepth& taken : job.messages) {
    --admitted_;
    admitted_bytes_ -= taken.depth.payload->size();
  }
  return job;
}

SurfaceStage::Result SurfaceStage::run(const Job& job, const StepTime& time) {
  Result result;
  if (job.accept_object) builder_.accept_object();
  for (std::size_t i = 0; i + 1 < job.messages.size(); ++i) skip(job.messages[i]);
  const ArrivedDepth& newest = job.messages.back();
  Decoded depth;
  if (!depth.message.ParseFromString(*newest.depth.payload)) {
    result.error = not_a_depth_image(newest);
    result.done = job.begun;
    return result;
  }
  const telepalp::Result<void> decoded = decode(newest, depth);
  result.done = time(StageStep::Decoded);
  if (!decoded) {
    fail(newest, decoded.error(), result);
    return result;
  }
  key_frame_request_.succeeded();
  if (const telepalp::Result<void> built = build(newest, depth, job, time, result); !built)
    result.error = built.error();
  return result;
}

void SurfaceStage::skip(const ArrivedDepth& message) {
  msg::DepthImage image;
  if (!message.decoded && image.ParseFromString(*message.depth.payload)) reader_.skip(std::move(*image.mutable_data()));
}

Result<void> SurfaceStage::decode(const ArrivedDepth& newest, Decoded& depth) {
  if (newest.decoded) {
    depth.mode = codec::depth_mode(depth.message.format()).value_or(codec::DepthMode::Fast);
    depth.image = newest.decoded;
  } else {
    telepalp::Result<codec::DecodedDepth> decoded = reader_.read(std::as_bytes(std::span(depth.message.data())));
    if (!decoded) return decoded.error();
    depth.mode = decoded->mode;
    depth.window = decoded->window;  // the packet's, not the message's: the packet's checksum covers it
    if (depth.window) keep_only(decoded->image, depth.window->exact);
    depth.image = std::make_shared<const DepthImage>(std::move(decoded->image));
  }
  if (depth.image->width != static_cast<int>(depth.message.width()) ||
      depth.image->height != static_cast<int>(depth.message.height()))
    return other_size(newest, depth.message);
  return {};
}

void SurfaceStage::report_window(const Decoded& depth, const Job& job, const Intrinsics& camera,
                                 msg::SurfaceReport& report) const {
  if (!depth.window) return;
  *report.mutable_window() = wire::to_message(*depth.window);
  report.set_hand_outside_window(job.device &&
                                 !covers(depth.window->exact, haptic_from_camera_->inverse() * *job.device, camera));
}

/// Reports the error and requests a key frame, unless both were done a moment ago.
void SurfaceStage::fail(const ArrivedDepth& newest, const Error& error, Result& result) {
  if (!key_frame_request_.failed(result.done)) return;
  result.error = error;
  result.unreadable = newest.depth;
}

bool SurfaceStage::place(const Decoded& depth, const Intrinsics& camera, Result& result) {
  if (haptic_from_camera_) return true;
  haptic_from_camera_ = result.placed = placement_(*depth.image, camera);
  if (haptic_from_camera_) builder_.watch(loop::mark_lines(effects_, haptic_from_camera_->inverse()));
  return haptic_from_camera_.has_value();
}

Result<void> SurfaceStage::build(const ArrivedDepth& newest, const Decoded& depth, const Job& job, const StepTime& time,
                                 Result& result) {
  const DepthImage& image = *depth.image;
  const SessionTime decoded = result.done;
  if (image.width != newest.camera.width || image.height != newest.camera.height) return other_camera(newest, image);
  if (!place(depth, newest.camera, result)) return not_measured(newest, depth.message);
  if (on_image_) on_image_(image, newest.camera, *haptic_from_camera_);
  const SessionTime captured = session_time(static_cast<std::int64_t>(depth.message.captured_ns()));
  const SessionTime begun = time(StageStep::Placed);
  begin_anew_if_clock_went_back(captured, begun);
  std::optional<surface::Reach> reach;
  if (job.device) reach = surface::Reach{haptic_from_camera_->inverse() * *job.device, surface::kReach_m};
  const auto snapshot = builder_.add(image, newest.camera, captured, reach);
  if (!snapshot) return not_newer(newest, depth.message);
  result.done = time(StageStep::Done);
  result.surface = loop::TouchableSurface{snapshot, *haptic_from_camera_, ++surfaces_};
  result.report = report_of(depth.message, depth.mode, newest.received, decoded, result.done, *snapshot);
  report_window(depth, job, newest.camera, result.report);
  judge(result.report, captured, to_seconds(result.done - begun));
  built_.fetch_add(1, std::memory_order_relaxed);
  return {};
}

/// After the session clock stepped back, the last image's capture time lies in the future, so each new image would
/// count as older and be dropped: the builder begins again. An image that a newer one has overtaken is still dropped,
/// because the capture time of the newer one is not in the future.
void SurfaceStage::begin_anew_if_clock_went_back(SessionTime captured, SessionTime now) {
  if (captured > last_captured_ || last_captured_ <= now + kClockStep) return;
  builder_.restart();
  last_captured_ = captured;
}

/// Reports the setting and the cost of the snapshot, and chooses the setting of the next one.
void SurfaceStage::judge(msg::SurfaceReport& report, SessionTime captured, double cost_s) {
  report.set_setting(choice_.now().name);
  report.set_build_ms(1e3 * cost_s);
  report.set_object_over_place(builder_.object_over_place());
  constexpr double kLongest_s = 0.1;  // of a frame period: a gap in the stream does not allow slower snapshots
  const double frame_s = std::min(kLongest_s, to_seconds(captured - last_captured_));
  last_captured_ = captured;
  if (choice_.add(cost_s, frame_s)) builder_.use(choice_.now());
}

}  // namespace telepalp::core
