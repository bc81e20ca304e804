// telepalp-gateway-stage: a real hub and gateway with a scripted patient and hand, to test a browser or a Foxglove
// client with states that a live station reaches rarely. Commands, one a line on stdin: pause, resume, phase NAME,
// stale on, stale off, bounded on, bounded off, hand on, hand off, swing on, swing off, at X Y Z: the end-effector
// rests at this place of H, under a camera 0.9 m above that looks down. End of stdin ends it.

#include <unistd.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/streambuf.hpp>
#include <cmath>
#include <cstdio>
#include <istream>
#include <optional>

#include "codec/color.h"
#include "codec/depth.h"
#include "foxglove/CameraCalibration.pb.h"
#include "foxglove/CompressedImage.pb.h"
#include "messages/camera.pb.h"
#include "messages/clock.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/session_clock.h"
#include "proto/wire/vector_message.h"
#include "server/gateway/gateway.h"
#include "server/hub/hub.h"
#include "support/program/options.h"

namespace telepalp {
namespace {

namespace asio = boost::asio;

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr double kFocal = 575.0;
constexpr double kBed_m = 1.10;

/// Height of a lying trunk over the bed, 0 beside it. x across, y along, both from the trunk's middle [m].
double trunk_m(double x, double y) {
  const double inside = 1.0 - std::pow(std::abs(x) / 0.19, 2.4) - std::pow(std::abs(y) / 0.40, 4.0);
  return inside <= 0.0 ? 0.0 : 0.21 * std::sqrt(inside);
}

struct Picture {
  DepthImage depth;
  ColorImage color;
};

/// What a camera above the bed sees at `t_s`.
Picture picture(double t_s) {
  Picture seen;
  seen.depth = {kWidth, kHeight, 0.001, std::vector<std::uint16_t>(kWidth * kHeight)};
  seen.color = {kWidth, kHeight, std::vector<std::uint8_t>(3 * kWidth * kHeight)};
  const double breath_m = 0.006 * std::sin(2.0 * 3.14159265 * 0.25 * t_s);
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column) {
      const auto pixel = static_cast<std::size_t>(row * kWidth + column);
      double z = kBed_m;
      for (int pass = 0; pass < 3; ++pass) {  // the ray's intersection, by iteration on its depth
        const double x = (column - kWidth / 2) * z / kFocal;
        const double y = (row - kHeight / 2) * z / kFocal;
        const double up = trunk_m(x, y);
        z = kBed_m - up - (up > 0.1 ? breath_m : 0.0);
      }
      const bool skin = z < kBed_m - 0.03;
      const bool hole = column % 97 == 3 && row % 41 < 3;
      seen.depth.samples[pixel] = hole ? std::uint16_t{0} : static_cast<std::uint16_t>(std::lround(z * 1000.0));
      const double shade = skin ? 0.75 + 0.25 * (kBed_m - z) / 0.21 : 0.9;
      const int base[3] = {skin ? 214 : 92, skin ? 164 : 118, skin ? 138 : 132};
      for (std::size_t band = 0; band < 3; ++band)
        seen.color.rgb[3 * pixel + band] = static_cast<std::uint8_t>(base[band] * shade);
    }
  return seen;
}

constexpr std::chrono::milliseconds kStatePeriod{10};

class Stage {
 public:
  Stage(asio::io_context& io, hub::Hub& hub, wire::SessionClock clock)
      : hub_(hub), clock_(clock), frame_timer_(io), state_timer_(io), stdin_(io, ::dup(0)) {
    camera();
    state();
    commands();
  }

 private:
  static double seconds(SessionTime at) { return static_cast<double>(to_nanoseconds(at) % 1'000'000'000'000) * 1e-9; }

  void camera() {
    if (!paused_) publish_frame();
    frame_timer_.expires_after(std::chrono::milliseconds(50));
    frame_timer_.async_wait([this](boost::system::error_code cancelled) {
      if (!cancelled) camera();
    });
  }

  void publish_frame() {
    const SessionTime now = clock_.now();
    const Picture seen = picture(seconds(now));
    captured_ns_ = static_cast<std::uint64_t>(to_nanoseconds(now));
    msg::DepthImage depth;
    depth.set_captured_ns(captured_ns_);
    depth.set_encoded_ns(captured_ns_ + 2'000'000);
    depth.set_sequence(++sequence_);
    depth.set_width(kWidth);
    depth.set_height(kHeight);
    depth.set_unit_m(0.001);
    depth.set_format(bounded_ ? "bounded" : "fast");
    if (bounded_) depth.mutable_bound()->set_least_m(0.001);
    if (bounded_) depth.mutable_bound()->set_per_m(0.00285);
    depth.set_data(codec::encode_depth(seen.depth));
    hub_.publish(wire::make_message(wire::kCameraDepth, now, depth, true));
    foxglove::CompressedImage color;
    color.set_format("jpeg");
    color.set_data(codec::encode_color(seen.color));
    hub_.publish(wire::make_message(wire::kCameraColor, now, color));
    if (sequence_ % 20 != 1) return;
    foxglove::CameraCalibration info;
    info.set_width(kWidth);
    info.set_height(kHeight);
    for (const double k : {kFocal, 0.0, kWidth / 2.0, 0.0, kFocal, kHeight / 2.0, 0.0, 0.0, 1.0}) info.add_k(k);
    hub_.publish(wire::make_message(wire::kCameraInfo, now, info));
    msg::CaptureStatus status;
    status.set_state(msg::CAPTURE_STATE_LIVE);
    status.set_source("stage");
    status.set_frames(sequence_);
    status.set_frames_per_s(20.0);
    status.set_color_registered(true);
    hub_.publish(wire::make_message(wire::kCameraStatus, now, status));
  }

  /// Like a station, publishes a state for each 10 ms, however late the timer comes on a busy machine.
  void state() {
    const SessionTime now = clock_.now();
    stated_ = std::max(stated_, now - std::chrono::seconds(1));
    for (; stated_ + kStatePeriod <= now; stated_ += kStatePeriod)
      if (!paused_) publish_state(stated_ + kStatePeriod);
    if (ticks_++ % 100 == 0) publish_clock();
    state_timer_.expires_after(kStatePeriod);
    state_timer_.async_wait([this](boost::system::error_code cancelled) {
      if (!cancelled) state();
    });
  }

  void publish_clock() {
    const SessionTime now = clock_.now();
    msg::Clock clock;
    clock.set_session_ns(static_cast<std::uint64_t>(to_nanoseconds(now)));
    hub_.publish(wire::make_message(wire::kClock, now, clock));
  }

  /// A hand that comes down on the trunk, presses 35 mm deep and leaves, every 6 s.
  void publish_state(SessionTime now) {
    const double turn = 2.0 * 3.14159265 * seconds(now) / 6.0;
    const double x = 0.05 * std::cos(turn / 3.0);
    const double y = 0.04 * std::sin(turn / 5.0);
    const double surface_z = kBed_m - trunk_m(x * 1.0, y * 1.0);
    const double above_m = 0.03 + 0.065 * std::cos(turn);
    const double indentation_m = std::max(0.0, -above_m);
    const double force_N = 2516.0 * indentation_m * (indentation_m * indentation_m + indentation_m);  // S1 eq. (7)
    const double device_z = surface_z - above_m;
    msg::StationState state;
    state.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(now)));
    state.set_surface_captured_ns(captured_ns_);
    if (hand_) hand_sampled_ns_ = state.stamp_ns();
    state.set_hand_sampled_ns(hand_sampled_ns_);
    state.set_phase(phase_.value_or(indentation_m > 0.0    ? msg::PHASE_IN_BODY
                                    : above_m > 0.02       ? msg::PHASE_OUT_BODY
                                    : std::sin(turn) > 0.0 ? msg::PHASE_PLANE_TO_BODY
                                                           : msg::PHASE_BODY_TO_PLANE));
    wire::set_vector(*state.mutable_force_n(), Eigen::Vector3d(0.0, force_N, 0.0));
    wire::set_vector(*state.mutable_displayed_hand_camera(), Eigen::Vector3d(x, y, std::min(device_z, surface_z)));
    wire::set_vector(*state.mutable_proxy_camera(), Eigen::Vector3d(x, y, std::min(device_z, surface_z)));
    wire::set_vector(*state.mutable_device_camera(), Eigen::Vector3d(x, y, device_z));
    wire::set_vector(*state.mutable_force_camera_n(), Eigen::Vector3d(0.0, 0.0, -force_N));
    wire::set_vector(*state.mutable_normal_camera(), Eigen::Vector3d(0.0, 0.0, -1.0));
    const double swing_m = swings_ ? 0.003 * std::sin(2.0 * 3.14159265 * 4.3 * seconds(now)) : 0.0;
    wire::set_vector(*state.mutable_hand(), Eigen::Vector3d(0.0, 0.05, 0.0));
    wire::set_vector(*state.mutable_device(), Eigen::Vector3d(0.0, 0.05 + swing_m, 0.0));
    if (rests_at_) {
      const Eigen::Vector3d& at = *rests_at_;
      wire::set_vector(*state.mutable_device(), at);
      wire::set_vector(*state.mutable_device_camera(), Eigen::Vector3d(at.x(), at.z(), 0.9 - at.y()));
    }
    state.set_distance_m(above_m);
    state.set_indentation_m(indentation_m);
    state.set_in_body(indentation_m > 0.0);
    state.set_surface_stale(stale_);
    hub_.publish(wire::make_message(wire::kStationState, now, state));
  }

  void commands() {
    asio::async_read_until(stdin_, line_, '\n', [this](boost::system::error_code failed, std::size_t) {
      if (failed) return stop();
      std::string line;
      std::istream read(&line_);
      std::getline(read, line);
      obey(line);
      commands();
    });
  }

  void obey(const std::string& line) {
    if (line == "pause" || line == "resume") paused_ = line == "pause";
    if (line == "stale on" || line == "stale off") stale_ = line == "stale on";
    if (line == "bounded on" || line == "bounded off") bounded_ = line == "bounded on";
    if (line == "swing on" || line == "swing off") swings_ = line == "swing on";
    if (line == "hand on" || line == "hand off") hand_ = line == "hand on";
    if (Eigen::Vector3d at; std::sscanf(line.c_str(), "at %lf %lf %lf", &at.x(), &at.y(), &at.z()) == 3) rests_at_ = at;
    msg::Phase phase{};
    if (line.starts_with("phase ") && msg::Phase_Parse(line.substr(6), &phase)) phase_ = phase;
  }

  void stop() {
    frame_timer_.cancel();
    state_timer_.cancel();
    static_cast<asio::io_context&>(stdin_.get_executor().context()).stop();
  }

  hub::Hub& hub_;
  wire::SessionClock clock_;
  asio::steady_timer frame_timer_;
  asio::steady_timer state_timer_;
  asio::posix::stream_descriptor stdin_;
  asio::streambuf line_{4096};
  std::uint64_t sequence_ = 0;
  std::uint64_t captured_ns_ = 0;
  SessionTime stated_{};  // time of the last state
  std::uint64_t ticks_ = 0;
  std::optional<msg::Phase> phase_;
  std::optional<Eigen::Vector3d> rests_at_;
  bool paused_ = false;
  bool stale_ = false;
  bool bounded_ = false;
  bool hand_ = true;
  bool swings_ = false;
  std::uint64_t hand_sampled_ns_ = 0;  // 0 until there is a hand
};

int run(const program::Arguments& arguments) {
  asio::io_context io;
  hub::Hub hub;
  const auto clock = wire::SessionClock::anchored_to_wall_clock();
  gateway::GatewayOptions options;
  const auto port = arguments.whole("http-port", 0, 65535);
  if (!port) return program::fail(port.error(), program::kAskedWrongly);
  options.port = static_cast<std::uint16_t>(*port);
  options.viewer_files = arguments.text("viewer");
  const auto gateway = gateway::Gateway::open(
      io, hub, [clock] { return clock.now(); }, options);
  if (!gateway) return program::fail(gateway.error());
  std::printf("%s\n", (*gateway)->url().c_str());
  std::fflush(stdout);
  Stage stage(io, hub, clock);
  io.run();
  return program::kDone;
}

}  // namespace
}  // namespace telepalp

int main(int argc, char** argv) {
  using namespace telepalp;
  const program::Usage usage{.program = "telepalp-gateway-stage",
                             .purpose = "Serves a scripted patient and hand to viewers, for tests.",
                             .positional = {},
                             .options = {{"http-port", "PORT", "where to listen; 0: any free port", "0"},
                                         {"viewer", "DIR", "the viewer's files", ""}},
                             .example = "telepalp-gateway-stage --http-port 8080 --viewer build/release/viewer"};
  return program::run_program(usage, argc, argv, run);
}
