#include "haptic_station/station/threads/surface_worker.h"

#include <algorithm>
#include <boost/asio/post.hpp>

namespace telepalp::station {
namespace {

// Ten seconds of a 30 Hz stream with 100 kB a frame. A message that is dropped before it is decoded breaks the chain of
// predicted frames until the next key frame, so all messages wait, as far as memory allows.
constexpr int kMostWaiting = 300;
constexpr std::size_t kMostWaitingBytes = 32U << 20U;

// The session clock steps by at least this. Smaller corrections are slewed, so it never runs back in between
// (proto/wire/clock_sync.h).
constexpr Nanoseconds kClockStep = std::chrono::seconds(1);

Error other_camera(const DepthImage& depth, const Intrinsics& camera) {
  return {.what = "the image is " + std::to_string(depth.width) + " x " + std::to_string(depth.height) +
                  " pixels, its camera model is for " + std::to_string(camera.width) + " x " +
                  std::to_string(camera.height),
          .where = "/camera/depth",
          .fix = "correct camera.textproto at the server"};
}

}  // namespace

SurfaceWorker::SurfaceWorker(const surface::SurfaceSettings& settings, Placement placement, Handlers handlers,
                             LatestValue<loop::TouchableSurface>& to_haptic, LatestValue<Point<HapticBase>>& device,
                             const effects::EffectBank& effects)
    : choice_(settings),
      builder_(settings),
      placement_(std::move(placement)),
      handlers_(std::move(handlers)),
      to_haptic_(to_haptic),
      device_(device),
      effects_(effects),
      stay_(boost::asio::make_work_guard(io_)),
      thread_([this] { io_.run(); }) {}

SurfaceWorker::~SurfaceWorker() {
  io_.stop();
  thread_.join();
}

void SurfaceWorker::offer(Work work) {
  ++offered_;
  const std::size_t bytes = work.depth.payload->size();
  if (waiting_ >= kMostWaiting || waiting_bytes_ + bytes > kMostWaitingBytes) return;
  ++waiting_;
  waiting_bytes_ += bytes;
  boost::asio::post(io_, [this, work = std::move(work)] { work_off(work); });
}

void SurfaceWorker::work_off(const Work& work) {
  waiting_bytes_ -= work.depth.payload->size();
  const bool is_newest = --waiting_ == 0;
  msg::DepthImage message;
  if (!message.ParseFromString(*work.depth.payload))
    return handlers_.on_bad_frame({.what = "the message is not a depth image",
                                   .where = "/camera/depth",
                                   .fix = "install the same version of telepalp at server and station"});
  if (!is_newest) return reader_.skip(std::move(*message.mutable_data()));
  const Result<codec::DecodedDepth> depth = read(message);
  if (!depth) {
    if (!key_frame_request_.failed(handlers_.now()))
      return;  // the error was reported and a key frame requested a moment ago
    handlers_.on_bad_frame(depth.error());
    return handlers_.request_key_frame(work.depth);
  }
  key_frame_request_.succeeded();
  const Result<msg::SurfaceReport> report = build(work, message, *depth);
  if (!report) return handlers_.on_bad_frame(report.error());
  built_.fetch_add(1, std::memory_order_relaxed);
  handlers_.on_report(*report);
}

Result<codec::DecodedDepth> SurfaceWorker::read(const msg::DepthImage& message) {
  Result<codec::DecodedDepth> depth = reader_.read(std::as_bytes(std::span(message.data())));
  if (!depth) return depth;
  if (depth->image.width != static_cast<int>(message.width()) ||
      depth->image.height != static_cast<int>(message.height()))
    return Error{.what = "the image's size is not the one that its message declares",
                 .where = "/camera/depth, image " + std::to_string(message.sequence()),
                 .fix = "install the same version of telepalp at server and station"};
  return depth;
}

/// The region around the device that the hand can reach before the next frame; nullopt, for the whole image, before the
/// first tick.
std::optional<surface::Reach> SurfaceWorker::reach() {
  device_known_ |= device_.take();
  if (!device_known_) return std::nullopt;
  return surface::Reach{.centre = haptic_from_camera_->inverse() * device_.current(), .radius_m = surface::kReach_m};
}

Result<msg::SurfaceReport> SurfaceWorker::build(const Work& work, const msg::DepthImage& message,
                                                const codec::DecodedDepth& decoded_depth) {
  const DepthImage& depth = decoded_depth.image;
  if (depth.width != work.camera.width || depth.height != work.camera.height) return other_camera(depth, work.camera);
  const SessionTime decoded = handlers_.now();
  if (!haptic_from_camera_ && (haptic_from_camera_ = placement_(depth, work.camera)))
    builder_.watch(loop::mark_lines(effects_, haptic_from_camera_->inverse()));
  if (!haptic_from_camera_)
    return Error{
        .what = "fewer than half of the pixels around the image's centre, where the patient should be, are measured",
        .where = "/camera/depth, image " + std::to_string(message.sequence()),
        .fix = "aim the camera at the patient, from a distance at which it measures"};
  if (handlers_.on_image) handlers_.on_image(depth, work.camera, *haptic_from_camera_);
  const SessionTime captured = session_time(static_cast<std::int64_t>(message.captured_ns()));
  const SessionTime begun = handlers_.now();
  begin_anew_if_clock_went_back(captured, begun);
  const auto snapshot = builder_.add(depth, work.camera, captured, reach());
  if (!snapshot)
    return Error{.what = "the image is not newer than the last one, or its size or camera model is invalid",
                 .where = "/camera/depth, image " + std::to_string(message.sequence()),
                 .fix = "check the camera's time stamps, and camera.textproto at the server"};
  to_haptic_.put({snapshot, *haptic_from_camera_});
  msg::SurfaceReport report;
  report.set_captured_ns(message.captured_ns());
  report.set_encoded_ns(message.encoded_ns());
  report.set_received_ns(static_cast<std::uint64_t>(to_nanoseconds(work.received)));
  report.set_decoded_ns(static_cast<std::uint64_t>(to_nanoseconds(decoded)));
  report.set_touchable_ns(static_cast<std::uint64_t>(to_nanoseconds(handlers_.now())));
  report.set_sequence(message.sequence());
  report.set_points(snapshot->points);
  report.set_index(snapshot->index_name);
  report.set_depth_mode(std::string(codec::name(decoded_depth.mode)));
  if (message.has_bound()) *report.mutable_depth_bound() = message.bound();
  judge(report, captured, to_seconds(handlers_.now() - begun));
  return report;
}

/// After the session clock stepped back, the last image's capture time lies in the future, so each new image would
/// count as older and be dropped: the builder begins anew. An image that a newer one has overtaken is still dropped,
/// because the capture time of the newer one is not in the future.
void SurfaceWorker::begin_anew_if_clock_went_back(SessionTime captured, SessionTime now) {
  if (captured > last_captured_ || last_captured_ <= now + kClockStep) return;
  builder_.restart();
  last_captured_ = captured;
}

/// Reports the setting and the cost of the snapshot, and chooses the setting of the next one.
void SurfaceWorker::judge(msg::SurfaceReport& report, SessionTime captured, double cost_s) {
  report.set_setting(choice_.now().name);
  report.set_build_ms(1e3 * cost_s);
  constexpr double kLongest_s = 0.1;  // of a frame period: a gap in the stream does not allow slower snapshots
  const double frame_s = std::min(kLongest_s, to_seconds(captured - last_captured_));
  last_captured_ = captured;
  if (choice_.add(cost_s, frame_s)) builder_.use(choice_.now());
}

}  // namespace telepalp::station
