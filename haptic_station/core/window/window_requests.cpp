#include "haptic_station/core/window/window_requests.h"

#include <algorithm>
#include <utility>

#include "codec/depth.h"
#include "haptic_station/core/window/tick_vector.h"
#include "proto/wire/camera/depth_window_message.h"

namespace telepalp::core {
namespace {

constexpr std::int64_t kPeriod_ns = 33'000'000;
constexpr std::int64_t kLongest_ns = 200'000'000;  // between ticks from which a velocity is computed
constexpr double kFrame_s = 1.0 / 30.0;
constexpr double kMostLead_s = 0.5;
constexpr Nanoseconds kBetweenSentences = std::chrono::seconds(5);

/// Velocity of the hand in H between two ticks; zero if they are too far apart.
Eigen::Vector3d velocity_between(const std::optional<loop::TickSample>& last, const loop::TickSample& tick) {
  if (!last || tick.stamp_ns - last->stamp_ns > kLongest_ns) return Eigen::Vector3d::Zero();
  const double between_s = 1e-9 * static_cast<double>(tick.stamp_ns - last->stamp_ns);
  return (vector_of(tick.hand) - vector_of(last->hand)) / between_s;
}

}  // namespace

std::optional<msg::WindowRequest> WindowRequests::due(const loop::TickSample& tick,
                                                      const Transform<HapticBase, DepthCamera>& haptic_from_camera,
                                                      const Intrinsics& camera) {
  // After the clock stepped back, the next request is due at once.
  if (last_ && tick.stamp_ns >= last_->stamp_ns && tick.stamp_ns - last_->stamp_ns < kPeriod_ns) return std::nullopt;
  if (last_ && tick.stamp_ns < last_->stamp_ns) last_.reset();
  const Eigen::Vector3d velocity = velocity_between(last_, tick);
  last_ = tick;
  const MovingHand hand{.device = {vector_of(tick.device_camera)},
                        .velocity_m_per_s = haptic_from_camera.iso.linear().transpose() * velocity};
  const double age_s = std::max(0.0, static_cast<double>(tick.surface_age_s));
  const Nanoseconds lead = from_seconds(std::min(kMostLead_s, 1.5 * age_s + kFrame_s));
  const std::optional<PixelRect> exact = hand_window(hand, lead, camera);
  if (!exact) return std::nullopt;
  msg::WindowRequest request;
  request.set_stamp_ns(static_cast<std::uint64_t>(tick.stamp_ns));
  *request.mutable_window() = wire::to_message(codec::window_around(*exact, codec::WindowGrowth::Growing));
  return request;
}

std::optional<std::string> WindowRequests::look(const msg::SurfaceReport& report, SessionTime now) {
  const bool was_outside = std::exchange(outside_, report.hand_outside_window());
  if (!outside_ || was_outside || (said_ && now - *said_ < kBetweenSentences)) return std::nullopt;
  said_ = now;
  return "the hand has left the part of the image that is exact, so it feels no force until exact images of its new "
         "place come. fix: move more slowly, or connect by a line with less delay";
}

}  // namespace telepalp::core
