#include "server/views/view_maker.h"

#include <boost/asio/post.hpp>
#include <set>
#include <span>
#include <utility>

#include "messages/station.pb.h"
#include "proto/wire/camera/calibration_message.h"
#include "server/views/depth_views.h"
#include "server/views/station_views.h"
#include "server/views/view_topics.h"

namespace telepalp::views {
namespace {

std::optional<Intrinsics> intrinsics_in(const std::string& payload) {
  foxglove::CameraCalibration calibration;
  return calibration.ParseFromString(payload) ? wire::intrinsics_of(calibration) : std::nullopt;
}

}  // namespace

ViewMaker::ViewMaker(boost::asio::io_context& io, hub::Hub& source, hub::Hub& views)
    : io_(io), source_(source), views_(views) {}

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
  need(kCloudView, {wire::kCameraDepth, wire::kCameraInfo});
  need(kTransformsView, {wire::kStationState, wire::kCameraInfo});
  need(kSceneView, {wire::kStationState});
  need(kHandView, {wire::kStationState});
  need(kUltrasoundView, {wire::kStationUltrasound});
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
  if (message.topic.name == wire::kCameraInfo.name) take_camera(message);
  if (message.topic.name == wire::kStationState.name) take_station(message);
  if (message.topic.name == wire::kStationUltrasound.name) take_ultrasound(message);
  if (message.topic.name == wire::kCameraDepth.name) decode(message);
}

void ViewMaker::take_camera(const wire::Message& message) {
  camera_ = intrinsics_in(*message.payload);
  if (views_.is_wanted(kTransformsView.name))
    views_.publish(
        wire::make_message(kTransformsView, message.published, transforms_view(std::nullopt, message.published)));
}

void ViewMaker::take_station(const wire::Message& message) {
  msg::StationState state;
  if (!state.ParseFromString(*message.payload)) return;
  if (views_.is_wanted(kSceneView.name))
    views_.publish(wire::make_message(kSceneView, message.published, scene_view(state)));
  if (views_.is_wanted(kTransformsView.name))
    views_.publish(wire::make_message(kTransformsView, message.published, transforms_view(state, message.published)));
  const std::optional<foxglove::PoseInFrame> hand = views_.is_wanted(kHandView.name) ? hand_view(state) : std::nullopt;
  if (hand) views_.publish(wire::make_message(kHandView, message.published, *hand));
}

void ViewMaker::take_ultrasound(const wire::Message& message) {
  msg::UltrasoundImage image;
  if (!image.ParseFromString(*message.payload)) return;
  if (const std::optional<foxglove::CompressedImage> view = ultrasound_view(image))
    views_.publish(wire::make_message(kUltrasoundView, message.published, *view));
}

void ViewMaker::decode(const wire::Message& message) {
  decoding_ = true;
  const WantedViews wanted{.image = views_.is_wanted(kDepthView.name), .cloud = views_.is_wanted(kCloudView.name)};
  boost::asio::post(pool_, [this, message, wanted, camera = camera_] {
    boost::asio::post(io_, [this, alive = std::weak_ptr<const bool>(alive_), message,
                            made = make(message, camera, wanted)]() mutable {
      if (!alive.expired()) on_made(message, std::move(made));
    });
  });
}

ViewMaker::Made ViewMaker::make(const wire::Message& message, const std::optional<Intrinsics>& camera,
                                WantedViews wanted) {
  msg::DepthImage packet;
  if (!packet.ParseFromString(*message.payload)) return {};
  const Result<DepthImage> depth = decoder_.decode(std::as_bytes(std::span(packet.data())));
  if (!depth) return {};
  const SessionTime captured = session_time(static_cast<std::int64_t>(packet.captured_ns()));
  Made made{.readable = true, .messages = {}};
  if (wanted.image)
    made.messages.push_back(wire::make_message(kDepthView, message.published, depth_view(*depth, captured)));
  if (wanted.cloud && camera && camera->width == depth->width && camera->height == depth->height)
    made.messages.push_back(wire::make_message(kCloudView, message.published, cloud_view(*depth, *camera, captured)));
  return made;
}

void ViewMaker::on_made(const wire::Message& depth, Made made) {
  decoding_ = false;
  if (made.readable) {
    ++decoded_;
  } else if (subscriber_ != 0) {
    source_.request_key_frame(subscriber_, depth.topic, depth.published);
  }
  for (wire::Message& message : made.messages) views_.publish(std::move(message));
  pull();
}

}  // namespace telepalp::views
