#include "tests/clients/report/made_session.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "codec/color.h"
#include "codec/depth_stream.h"
#include "foxglove/CameraCalibration.pb.h"
#include "foxglove/CompressedImage.pb.h"
#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/vector_message.h"

namespace telepalp::report {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kWidth = 320, kHeight = 240;
constexpr double kFocal_px = 262.5;

std::uint64_t stamp(double at_s) { return static_cast<std::uint64_t>(kMadeStart_ns + std::llround(at_s * 1e9)); }
SessionTime time_of(double at_s) { return session_time(static_cast<std::int64_t>(stamp(at_s))); }

/// Depth of the cushion's surface at pixel (u, v) [m]: a dome 20 cm high on a table 1.2 m away.
double cushion_z(int u, int v) {
  const double x = (u - kWidth / 2) / kFocal_px, y = (v - kHeight / 2) / kFocal_px;
  const double inside = 1.0 - x * x / 0.05 - y * y / 0.16;
  return 1.2 - (inside > 0.0 ? 0.2 * std::sqrt(inside) : 0.0);
}

DepthImage depth_image() {
  DepthImage depth{kWidth, kHeight, 0.001, {}};
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u)
      depth.samples.push_back(static_cast<std::uint16_t>(std::lround(1000.0 * cushion_z(u, v))));
  return depth;
}

ColorImage color_image() {
  ColorImage color{kWidth, kHeight, {}};
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) {
      const bool cushion = cushion_z(u, v) < 1.199;
      const int stripe = (u / 20 + v / 20) % 2 == 0 ? 12 : 0;
      for (const int value : cushion ? std::array{214, 176, 152} : std::array{88, 120, 138})
        color.rgb.push_back(static_cast<std::uint8_t>(value - stripe));
    }
  return color;
}

/// The hand at one instant: height above the skin [m], and the station's state.
struct Instant {
  double height_m, indentation_m, force_N, sideways_m;
  msg::Phase phase;
};

Instant instant_at(double at_s) {
  const double along = std::fmod(at_s, 2.0) / 2.0;
  const double height = 0.035 * std::cos(2.0 * kPi * along);  // above, in, above
  Instant now{height, std::max(0.0, -height), 0.0, 0.006 * std::sin(6.0 * kPi * along), msg::PHASE_OUT_BODY};
  const bool leaving = along > 0.5;
  now.force_N = 2516.0 * (now.indentation_m * now.indentation_m + now.indentation_m) * now.indentation_m *
                (leaving ? 0.85 : 1.0) * 1.6;
  if (height < 0.0)
    now.phase = msg::PHASE_IN_BODY;
  else if (height < 0.008)
    now.phase = leaving ? msg::PHASE_BODY_TO_PLANE : msg::PHASE_PLANE_TO_BODY;
  if (at_s > 2.0 && height < -0.02) {
    now.phase = height < -0.03 ? msg::PHASE_CYLINDER_UPPER : msg::PHASE_CYLINDER_LATERAL;
    now.force_N += 1.5;
  }
  return now;
}

msg::StationTicks ticks_from(int first, int count) {
  msg::StationTicks batch;
  batch.set_first_tick_ns(stamp(first * 5e-4));
  batch.set_first_tick(static_cast<std::uint64_t>(first));
  batch.set_period_ns(500'000);
  for (int i = first; i < first + count; ++i) {
    const Instant now = instant_at(i * 5e-4);
    const auto y = static_cast<float>(now.height_m), x = static_cast<float>(now.sideways_m);
    batch.add_late_ns(static_cast<std::uint32_t>(3000 + 1500 * (i * 7919 % 97)));
    batch.add_work_us(static_cast<float>(6.0 + 0.1 * (i * 104729 % 61) + (i % 997 == 0 ? 60.0 : 0.0)));
    batch.add_phase(now.phase);
    batch.add_hand_x(x);
    batch.add_hand_y(y + 0.002F * std::sin(static_cast<float>(i) * 0.01F));
    batch.add_hand_z(0.0F);
    batch.add_device_x(x);
    batch.add_device_y(std::max(y, -0.034F));
    batch.add_device_z(0.5F * x);
    batch.add_proxy_x(0.0F);
    batch.add_proxy_y(0.0F);
    batch.add_proxy_z(0.0F);
    batch.add_force_x(static_cast<float>(-80.0 * now.sideways_m * (now.force_N > 0.0 ? 1.0 : 0.0)));
    batch.add_force_y(static_cast<float>(now.force_N));
    batch.add_force_z(static_cast<float>(-40.0 * now.sideways_m * (now.force_N > 0.0 ? 1.0 : 0.0)));
    batch.add_indentation_m(static_cast<float>(now.indentation_m));
    batch.add_distance_m(y);
  }
  return batch;
}

msg::StationState state_at(double at_s) {
  const Instant now = instant_at(at_s);
  msg::StationState state;
  state.set_stamp_ns(stamp(at_s));
  state.set_surface_captured_ns(at_s > 0.05 ? stamp(std::floor((at_s - 0.02) * 30.0) / 30.0) : 0);
  state.set_phase(now.phase);
  wire::set_vector(*state.mutable_force_n(), Eigen::Vector3d(0.0, now.force_N, 0.0));
  wire::set_vector(*state.mutable_device_camera(), Eigen::Vector3d(now.sideways_m, 0.0, 1.0 - now.height_m));
  wire::set_vector(*state.mutable_proxy_camera(),
                   Eigen::Vector3d(now.sideways_m, 0.0, std::min(1.0, 1.0 - now.height_m)));
  wire::set_vector(*state.mutable_displayed_hand_camera(),
                   Eigen::Vector3d(now.sideways_m, 0.0, std::min(1.0, 1.0 - now.height_m)));
  wire::set_vector(*state.mutable_force_camera_n(), Eigen::Vector3d(0.0, 0.0, -now.force_N));
  state.set_indentation_m(now.indentation_m);
  state.set_in_body(now.indentation_m > 0.0);
  state.set_passivity_j(2e-3 * now.indentation_m / 0.035);
  state.set_hand_excess_j(-1e-3 * now.indentation_m / 0.035);
  state.set_yields_in_s(at_s > 2.5 && at_s < 2.8 ? 2.9 - at_s : std::numeric_limits<double>::infinity());
  return state;
}

msg::DepthBound default_bound() {
  const DepthErrorBound bound = codec::kOneDisparityStep;
  msg::DepthBound message;
  message.set_least_m(bound.least_m);
  message.set_per_m(bound.per_m);
  return message;
}

void add_camera(std::vector<wire::Message>& out, const MadeSession& made) {
  const double seconds = made.seconds;
  foxglove::CameraCalibration calibration;
  calibration.set_frame_id("camera_depth");
  calibration.set_width(kWidth);
  calibration.set_height(kHeight);
  for (const double entry : {kFocal_px, 0.0, kWidth / 2.0, 0.0, kFocal_px, kHeight / 2.0, 0.0, 0.0, 1.0})
    calibration.add_k(entry);
  out.push_back(wire::make_message(wire::kCameraInfo, time_of(0.0), calibration));
  const std::string color_bytes = codec::encode_color(color_image());
  codec::DepthEncoder encoder({.mode = made.depth_mode, .key_every = made.key_every});
  const DepthImage scene = depth_image();
  for (int frame = 0; frame / 30.0 < seconds; ++frame) {
    msg::DepthImage depth;
    depth.set_captured_ns(stamp(frame / 30.0));
    const codec::EncodedDepth encoded = encoder.encode(scene);
    depth.set_data(encoded.bytes);
    depth.set_format(std::string(codec::name(made.depth_mode)));
    if (made.depth_mode == codec::DepthMode::Bounded) *depth.mutable_bound() = default_bound();
    out.push_back(wire::make_message(wire::kCameraDepth, time_of(frame / 30.0 + 0.002), depth, encoded.key_frame));
    foxglove::CompressedImage color;
    color.mutable_timestamp()->set_seconds(static_cast<std::int64_t>(stamp(frame / 30.0) / 1'000'000'000));
    color.mutable_timestamp()->set_nanos(static_cast<std::int32_t>(stamp(frame / 30.0) % 1'000'000'000));
    color.set_format("jpeg");
    color.set_data(color_bytes);
    out.push_back(wire::make_message(wire::kCameraColor, time_of(frame / 30.0 + 0.003), color));
  }
  msg::ServerStats stats;
  auto& topic = *stats.add_topics();
  topic.set_topic("/camera/depth");
  topic.set_sent(240);
  topic.set_dropped(9);
  auto& subscriber = *stats.add_subscribers();
  subscriber.set_name("telepalp-station");
  auto& to_station = *subscriber.add_topics();
  to_station.set_topic("/camera/depth");
  to_station.set_sent(118);
  to_station.set_dropped(2);
  out.push_back(wire::make_message(wire::kServerStats, time_of(seconds), stats));
}

void add_station(std::vector<wire::Message>& out, const MadeSession& made) {
  const double seconds = made.seconds;
  const int ticks = static_cast<int>(seconds * 2000.0);
  for (int first = 0; first < ticks; first += 100)
    out.push_back(wire::make_message(wire::kStationTicks, time_of((first + 100) * 5e-4), ticks_from(first, 100)));
  for (int i = 0; i < static_cast<int>(seconds * 100.0); ++i)
    out.push_back(wire::make_message(wire::kStationState, time_of(i * 0.01), state_at(i * 0.01)));
  for (int i = 0; i < static_cast<int>(seconds * 100.0); ++i) {
    msg::StationCompensation message;
    message.set_stamp_ns(stamp(i * 0.01));
    message.set_surface_age_s(0.03);
    message.set_clock_error_s(0.004);
    message.set_surface_carried_m(i % 2 == 0 ? 0.0002 : -0.0002);
    message.set_hand_carried_m(0.001);
    out.push_back(wire::make_message(wire::kStationCompensation, time_of(i * 0.01), message));
  }
  for (int frame = 0; frame / 30.0 < seconds - 0.1; ++frame) {
    msg::SurfaceReport surface;
    const double at = frame / 30.0;
    surface.set_captured_ns(stamp(at));
    surface.set_depth_mode(std::string(codec::name(made.depth_mode)));
    if (made.depth_mode == codec::DepthMode::Bounded) *surface.mutable_depth_bound() = default_bound();
    surface.set_encoded_ns(stamp(at + 0.003));
    surface.set_received_ns(stamp(at + 0.0045 + 0.0001 * (frame % 11)));
    surface.set_decoded_ns(stamp(at + 0.0075));
    surface.set_touchable_ns(stamp(at + 0.019 + 0.0005 * (frame % 9)));
    surface.set_clock_error_s(0.004);
    out.push_back(wire::make_message(wire::kStationSurface, time_of(at + 0.02), surface));
  }
  msg::StationStats stats;
  stats.set_ticks(static_cast<std::uint64_t>(ticks));
  stats.set_deadlines_missed(3);
  stats.set_frames_received(118);
  stats.set_realtime(true);
  auto& skin = *stats.add_bill();
  skin.set_name("skin");
  skin.set_mean_us(3.2);
  skin.set_max_us(6.1);
  out.push_back(wire::make_message(wire::kStationStats, time_of(seconds), stats));
}

}  // namespace

std::vector<wire::Message> made_messages(const MadeSession& made) {
  std::vector<wire::Message> messages;
  if (made.with_camera) add_camera(messages, made);
  if (made.with_station) add_station(messages, made);
  std::stable_sort(messages.begin(), messages.end(),
                   [](const wire::Message& a, const wire::Message& b) { return a.published < b.published; });
  return messages;
}

}  // namespace telepalp::report
