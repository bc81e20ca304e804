#include "tests/bench/thin/live_hand.h"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "foxglove/CameraCalibration.pb.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "proto/wire/camera/calibration_message.h"
#include "proto/wire/camera/color_message.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;

// A calm hand: a circle on the skin, at 0.13 m/s.
constexpr double kCircle_m = 0.08;
constexpr double kPeriod_s = 4.0;

core::SurfaceStage surface_stage(core::SurfaceStage::OnImage on_image) {
  return {*surface::surface_settings("fast"),
          [](const DepthImage&, const Intrinsics&) { return Transform<HapticBase, DepthCamera>{}; },
          {},
          std::move(on_image)};
}

/// Depth of the first measured pixel to the right of the middle of the image; nullopt: none.
std::optional<double> middle_m(const DepthImage& image) {
  for (int column = image.width / 2; column < image.width; ++column)
    if (const auto sample = image.at(column, image.height / 2); sample != 0) return sample * image.unit_m;
  return std::nullopt;
}

double seconds_of(std::uint64_t stamp_ns) { return 1e-9 * static_cast<double>(stamp_ns); }

}  // namespace

LiveHand::LiveHand(std::uint16_t port)
    : link_(io_,
            {.port = port,
             .name = "telepalp-bench",
             .role = "doctor",
             .subscribes = {wire::kCameraDepthWindow.name.data(), wire::kCameraColorVideo.name.data(),
                            wire::kCameraInfo.name.data(), wire::kCameraStatus.name.data()},
             .publishes = {wire::kStationWindow}},
            {.on_message = [this](const wire::Message& message) { on_message(message); },
             .on_state = [](wire::LinkState, const std::string&) {}}),
      stage_(surface_stage([this](const DepthImage& image, const Intrinsics&,
                                  const Transform<HapticBase, DepthCamera>&) { look_at(image); })) {
  link_.start();
  ask_often();
  network_ = std::thread([this] { io_.run(); });
  surfaces_ = std::thread([this] { make_surfaces(); });
}

LiveHand::~LiveHand() { (void)end(); }

double LiveHand::now_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
}

HandRecord LiveHand::end() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  came_.notify_all();
  if (surfaces_.joinable()) surfaces_.join();
  boost::asio::post(io_, [this] {
    stopped_ = true;
    ask_timer_.cancel();
    link_.stop();
  });
  if (network_.joinable()) network_.join();
  return record_;
}

void LiveHand::on_message(const wire::Message& message) {
  if (message.topic.name == wire::kCameraDepthWindow.name) return on_depth(message);
  if (message.topic.name == wire::kCameraColorVideo.name) return on_color(message);
  if (message.topic.name == wire::kCameraInfo.name) {
    foxglove::CameraCalibration calibration;
    if (calibration.ParseFromString(*message.payload)) camera_ = wire::intrinsics_of(calibration);
    return;
  }
  msg::CaptureStatus status;
  if (message.topic.name != wire::kCameraStatus.name || !status.ParseFromString(*message.payload)) return;
  const std::lock_guard lock(mutex_);
  const std::size_t given_up = status.detail().find("; the line");
  std::string said = given_up == std::string::npos ? "" : status.detail().substr(given_up + 2);
  if (status.detail().find("too thin to touch") != std::string::npos) said = status.detail();
  if (record_.said.empty() || record_.said.back() != said) record_.said.push_back(std::move(said));
}

void LiveHand::on_depth(const wire::Message& message) {
  if (!camera_ || !stage_.admit(message.payload->size())) return;
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({.depth = message, .camera = *camera_, .received = link_.clock().now()});
    if (const auto unreadable = std::exchange(unreadable_, std::nullopt)) link_.request_key_frame(*unreadable);
  }
  came_.notify_one();
}

void LiveHand::on_color(const wire::Message& message) {
  const auto color = wire::compressed_color(message);
  if (!color) return;
  if (message.sequence != color_number_ + 1) video_.lose_frame();
  color_number_ = message.sequence;
  if (video_.take(std::as_bytes(std::span(color->data)))) {
    const std::lock_guard lock(mutex_);
    record_.color_s.push_back(now_s());
    return;
  }
  const std::lock_guard lock(mutex_);
  ++record_.unreadable;
  link_.request_key_frame(message);
}

Point<DepthCamera> LiveHand::hand_at(double at_s) const {
  const double angle = 2.0 * std::numbers::pi * at_s / kPeriod_s;
  return {{kCircle_m * std::cos(angle), kCircle_m * std::sin(angle), distance_m_}};
}

void LiveHand::ask_often() {
  ask_timer_.expires_after(5ms);
  ask_timer_.async_wait([this](const boost::system::error_code& stopped) {
    if (stopped || stopped_) return;  // a timer that has expired cannot be cancelled
    if (camera_ && link_.state() == wire::LinkState::Connected) {
      const SessionTime now = link_.clock().now();
      loop::TickSample tick;
      tick.stamp_ns = to_nanoseconds(now);
      const std::lock_guard lock(mutex_);
      const Eigen::Vector3f hand = hand_at(now_s()).m.cast<float>();
      tick.hand = tick.device = tick.device_camera = {hand.x(), hand.y(), hand.z()};
      tick.surface_age_s = static_cast<float>(
          newest_captured_s_ > 0.0 ? 1e-9 * static_cast<double>(tick.stamp_ns) - newest_captured_s_ : 0.1);
      if (const auto request = requests_.due(tick, {}, *camera_))
        (void)link_.publish(wire::make_message(wire::kStationWindow, now, *request));
    }
    ask_often();
  });
}

/// The hand stays on the skin of the first image.
void LiveHand::look_at(const DepthImage& image) {
  if (std::exchange(has_looked_, true)) return;
  const std::lock_guard lock(mutex_);
  distance_m_ = middle_m(image).value_or(distance_m_);
}

void LiveHand::make_surfaces() {
  for (;;) {
    std::unique_lock lock(mutex_);
    came_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
    if (ended_) return;
    for (core::ArrivedDepth& arrived : std::exchange(waiting_, {})) stage_.arrived(std::move(arrived));
    const Point<HapticBase> device{hand_at(now_s()).m};
    lock.unlock();
    const wire::SessionClock clock = link_.clock();
    const auto job = stage_.take(clock.now(), device);
    if (!job) continue;
    keep(stage_.run(*job, [&](core::StageStep) { return link_.clock().now(); }));
  }
}

void LiveHand::keep(const core::SurfaceStage::Result& made) {
  const std::lock_guard lock(mutex_);
  if (made.unreadable) {
    ++record_.unreadable;
    unreadable_ = made.unreadable;
  }
  if (!made.surface) return;
  const double at_s = now_s();
  const double age_s = seconds_of(made.report.touchable_ns()) - seconds_of(made.report.captured_ns());
  newest_captured_s_ = seconds_of(made.report.captured_ns());
  record_.surfaces.push_back({.captured_s = at_s - age_s, .at_s = at_s, .inside = !made.report.hand_outside_window()});
}

}  // namespace telepalp::bench
