#include "server/views/view_maker.h"

#include <boost/asio/post.hpp>
#include <cstdlib>
#include <set>
#include <span>
#include <utility>

#include "codec/color.h"
#include "foxglove/CompressedImage.pb.h"
#include "messages/camera.pb.h"
#include "proto/wire/camera/calibration_message.h"
#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/inside/inside_message.h"
#include "server/views/depth_views.h"
#include "server/views/inside_views.h"
#include "server/views/station_views.h"
#include "server/views/view_topics.h"

namespace telepalp::views {
namespace {

constexpr auto kPatience = std::chrono::milliseconds(100);
/// A colour image that was taken at most this long from a depth image colours its cloud.
constexpr std::int64_t kSameMoment_ns = 100'000'000;

std::optional<Intrinsics> intrinsics_in(const std::string& payload) {
  foxglove::CameraCalibration calibration;
  return calibration.ParseFromString(payload) ? wire::intrinsics_of(calibration) : std::nullopt;
}

}  // namespace

ViewMaker::ViewMaker(boost::asio::io_context& io, hub::Hub& source, hub::Hub& views, Say say)
    : io_(io), source_(source), views_(views), say_(std::move(say)), patience_(io) {}

ViewMaker::~ViewMaker() {
  pool_.join();
  if (subscriber_ != 0) source_.leave(subscriber_);
}

std::vector<std::string> ViewMaker::topics_needed() const {
  std::set<std::string_view> needed;
  const auto need = [&](const wire::Topic& view, std::initializer_list<wire::Topic> from) {
    if (!views_.is_wanted(view.name)) return;
    for (const wire::Topic& topic : from) needed.insert(topic.name);
  };
  need(kDepthView, {wire::kCameraDepth});
  need(kCloudView, {wire::kCameraDepth, wire::kCameraInfo, wire::kCameraColor, wire::kCameraColorInfo});
  need(kTransformsView, {wire::kStationState, wire::kCameraInfo, wire::kStationInside, wire::kStationCompensation});
  need(kSceneView, {wire::kStationState});
  need(kHandView, {wire::kStationState});
  need(kPhaseView, {wire::kStationState});
  need(kUltrasoundView, {wire::kStationUltrasound});
  need(kInsideView, {wire::kStationInside});
  return {needed.begin(), needed.end()};
}

void ViewMaker::subscriptions_changed() {
  const std::vector<std::string> needed = topics_needed();
  if (needed == topics_) return;
  topics_ = needed;
  if (needed.empty()) return source_.leave(std::exchange(subscriber_, 0));
  if (subscriber_ == 0) subscriber_ = source_.join("views for Foxglove", "this server", [this] { pull(); });
  source_.subscribe(subscriber_, needed);
}

void ViewMaker::pull() {
  while (subscriber_ != 0 && !decoding_) {
    const std::optional<wire::Message> message = source_.next(subscriber_);
    if (!message) return;
    take(*message);
  }
}

void ViewMaker::take(const wire::Message& message) {
  const std::string_view topic = message.topic.name;
  if (topic == wire::kCameraInfo.name) take_camera(message);
  if (topic == wire::kCameraColorInfo.name) take_color_camera(message);
  if (topic == wire::kCameraColor.name) take_color(message);
  if (topic == wire::kCameraDepth.name) take_depth(message);
  if (topic == wire::kStationState.name) take_station(message);
  if (topic == wire::kStationUltrasound.name) take_ultrasound(message);
  if (topic == wire::kStationInside.name) take_inside(message);
  if (topic == wire::kStationCompensation.name && !compensation_.ParseFromString(*message.payload))
    say_unreadable(message);
}

void ViewMaker::say(const Error& error) {
  const auto line = errors_.line("left out of the views for Foxglove", error, std::chrono::steady_clock::now());
  if (line) say_(*line);
}

void ViewMaker::say_unreadable(const wire::Message& message) {
  say({.what = "the message is not of the type of " + std::string(message.topic.name) + ", or holds impossible values",
       .where = std::string(message.topic.name),
       .fix = "install the same version of telepalp at server and station; record the session again if it is a file"});
}

void ViewMaker::take_color_camera(const wire::Message& message) {
  color_camera_ = intrinsics_in(*message.payload);
  if (!color_camera_) say_unreadable(message);
}

void ViewMaker::take_camera(const wire::Message& message) {
  depth_camera_ = intrinsics_in(*message.payload);
  if (!depth_camera_) say_unreadable(message);
  if (views_.is_wanted(kTransformsView.name))
    views_.publish(
        wire::make_message(kTransformsView, message.published, transforms_view(std::nullopt, message.published)));
}

void ViewMaker::take_station(const wire::Message& message) {
  msg::StationState state;
  if (!state.ParseFromString(*message.payload)) return say_unreadable(message);
  if (views_.is_wanted(kSceneView.name))
    views_.publish(wire::make_message(kSceneView, message.published, scene_view(state)));
  if (views_.is_wanted(kTransformsView.name)) {
    foxglove::FrameTransforms all = transforms_view(state, message.published);
    add_inside_transforms(all, inside_, compensation_, message.published);
    views_.publish(wire::make_message(kTransformsView, message.published, all));
  }
  if (views_.is_wanted(kPhaseView.name))
    views_.publish(wire::make_message(kPhaseView, message.published, phase_view(state)));
  const std::optional<foxglove::PoseInFrame> hand = views_.is_wanted(kHandView.name) ? hand_view(state) : std::nullopt;
  if (hand) views_.publish(wire::make_message(kHandView, message.published, *hand));
}

void ViewMaker::take_ultrasound(const wire::Message& message) {
  msg::UltrasoundImage image;
  if (!image.ParseFromString(*message.payload)) return say_unreadable(message);
  if (const std::optional<foxglove::CompressedImage> view = ultrasound_view(image))
    views_.publish(wire::make_message(kUltrasoundView, message.published, *view));
}

void ViewMaker::take_inside(const wire::Message& message) {
  msg::InnerStructures inside;
  if (!inside.ParseFromString(*message.payload) || !wire::is_valid(inside)) return say_unreadable(message);
  inside_ = std::move(inside);
  if (views_.is_wanted(kInsideView.name))
    views_.publish(wire::make_message(kInsideView, message.published, inside_view(inside_)));
}

void ViewMaker::take_color(const wire::Message& message) {
  foxglove::CompressedImage image;
  if (!image.ParseFromString(*message.payload)) return say_unreadable(message);
  color_ = Color{.captured_ns = wire::stamp_ns(image.timestamp()),
                 .registered = image.frame_id() == wire::kDepthFrameId,
                 .jpeg = std::move(*image.mutable_data())};
  if (waiting_ && color_->captured_ns >= waiting_->captured_ns) stop_waiting();
}

void ViewMaker::take_depth(const wire::Message& message) {
  msg::DepthImage image;
  const std::int64_t captured_ns =
      image.ParseFromString(*message.payload) ? static_cast<std::int64_t>(image.captured_ns()) : 0;
  stop_waiting();
  const bool is_colored = color_ && captured_ns - color_->captured_ns < 10 * kSameMoment_ns;
  const bool waits = is_colored && color_->captured_ns < captured_ns && views_.is_wanted(kCloudView.name);
  if (!waits && !decoding_) return decode(message, captured_ns);
  waiting_ = Waiting{message, captured_ns};
  patience_.expires_after(kPatience);
  patience_.async_wait([this, alive = std::weak_ptr<const bool>(alive_)](const boost::system::error_code& cancelled) {
    if (!cancelled && !alive.expired()) stop_waiting();
  });
}

void ViewMaker::stop_waiting() {
  if (!waiting_ || decoding_) return;
  patience_.cancel();
  const Waiting ready = *std::exchange(waiting_, std::nullopt);
  decode(ready.depth, ready.captured_ns);
}

void ViewMaker::decode(const wire::Message& depth, std::int64_t captured_ns) {
  decoding_ = true;
  Job job{.depth = depth,
          .wanted = {.image = views_.is_wanted(kDepthView.name), .cloud = views_.is_wanted(kCloudView.name)},
          .color = {},
          .depth_camera = depth_camera_,
          .color_camera = color_camera_};
  if (job.wanted.cloud && color_ && std::abs(color_->captured_ns - captured_ns) <= kSameMoment_ns) job.color = color_;
  boost::asio::post(pool_, [this, job = std::move(job)] {
    boost::asio::post(io_,
                      [this, alive = std::weak_ptr<const bool>(alive_), depth = job.depth, made = make(job)]() mutable {
                        if (!alive.expired()) on_made(depth, std::move(made));
                      });
  });
}

ViewMaker::Made ViewMaker::make(const Job& job) {
  const std::string where(job.depth.topic.name);
  msg::DepthImage packet;
  if (!packet.ParseFromString(*job.depth.payload))
    return {.unreadable = Error{.what = "the message is not of the type of " + where,
                                .where = where,
                                .fix = "install the same version of telepalp at both ends"}};
  Result<DepthImage> depth = decoder_.decode(std::as_bytes(std::span(packet.data())));
  if (!depth) return {.unreadable = depth.error()};
  RgbdFrame frame;
  frame.captured = session_time(static_cast<std::int64_t>(packet.captured_ns()));
  frame.depth = std::move(*depth);
  Made made;
  if (job.wanted.image)
    made.messages.push_back(
        wire::make_message(kDepthView, job.depth.published, depth_view(frame.depth, frame.captured)));
  if (job.wanted.cloud && job.depth_camera) add_cloud(made, job, std::move(frame));
  return made;
}

void ViewMaker::add_cloud(Made& made, const Job& job, RgbdFrame frame) const {
  frame.camera = {.depth = *job.depth_camera,
                  .color = job.color_camera.value_or(*job.depth_camera),
                  .color_registered = !job.color || job.color->registered};
  if (job.color) {
    Result<ColorImage> color = codec::decode_color(std::as_bytes(std::span(job.color->jpeg)));
    if (color)
      frame.color = std::move(*color);
    else
      made.left_out = color.error();
  }
  if (is_well_formed(frame))
    made.messages.push_back(wire::make_message(kCloudView, job.depth.published, cloud_view(frame)));
  else
    made.left_out = Error{.what = "the images do not have the size that the camera's model states",
                          .where = std::string(kCloudView.name),
                          .fix = "correct width and height in the server's camera.textproto"};
}

void ViewMaker::on_made(const wire::Message& depth, Made made) {
  decoding_ = false;
  if (made.unreadable) {
    on_unreadable(depth, *made.unreadable);
  } else {
    ++decoded_;
    unreadable_since_.reset();
  }
  if (made.left_out) say(*made.left_out);
  for (wire::Message& message : made.messages) views_.publish(std::move(message));
  pull();
  if (waiting_ && patience_.expiry() <= std::chrono::steady_clock::now()) stop_waiting();
}

/// A view that begins within a group of pictures decodes nothing until the next key frame, which comes within a second.
void ViewMaker::on_unreadable(const wire::Message& depth, const Error& error) {
  constexpr std::chrono::seconds kLongestWait{2};
  const auto now = std::chrono::steady_clock::now();
  if (!unreadable_since_) unreadable_since_ = now;
  if (now - *unreadable_since_ > kLongestWait) say(error);
  if (subscriber_ != 0) source_.request_key_frame(subscriber_, depth.topic, depth.published);
}

}  // namespace telepalp::views
