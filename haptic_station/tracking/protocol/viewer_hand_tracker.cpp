#include "haptic_station/tracking/protocol/viewer_hand_tracker.h"

#include <algorithm>

namespace telepalp::tracking {
namespace {

constexpr std::chrono::milliseconds kPassing{300};  // three times the tracker age at which a station releases
constexpr double kReach_m = 0.5;

/// False for NaN, too.
bool in_reach(const Point<HapticBase>& at) noexcept { return at.m.norm() <= kReach_m; }

}  // namespace

ViewerHandTracker::Taken ViewerHandTracker::hear(const msg::ViewerHand& hand, const Point<HapticBase>& at,
                                                 Clock::time_point now) noexcept {
  const bool another = hand.viewer() != viewer_;
  if (another && viewer_ != 0 && now - heard_ < kPassing) return Taken::Passing;
  if (!in_reach(at)) return Taken::OutOfReach;
  if (another) viewers_clock_ = ClockEnvelope();
  viewer_ = hand.viewer();
  heard_ = now;
  // About a century, so that the clock of a viewer cannot overflow session time.
  constexpr std::uint64_t kLatest_us = 3'200'000'000'000'000;
  const std::chrono::microseconds sampled(static_cast<std::int64_t>(std::min(hand.sampled_us(), kLatest_us)));
  latest_hand_.put(Clock::time_point(viewers_clock_.map(sampled, now.time_since_epoch())), at, std::nullopt,
                   {hand.hovers()});
  return Taken::Followed;
}

std::optional<ports::HandSample> ViewerHandTracker::sample_at(SessionTime now, Clock::time_point steady,
                                                              const ports::DeviceReading& device) noexcept {
  (void)skin_.take();
  const auto seen = latest_hand_.take(now, steady);
  if (!seen) return std::nullopt;
  const double since_s = sampled_ ? to_seconds(seen->at - *sampled_) : 0.0;
  sampled_ = seen->at;
  const GuidedHand::Guided guided =
      guided_.follow({seen->hand, seen->more.hovers}, device.at, skin_.current(), since_s);
  return ports::HandSample{.at = seen->at, .hand = guided.hand, .wait_at_m = guided.wait_at_m};
}

const char* in_words(ViewerHandTracker::Taken taken) noexcept {
  switch (taken) {
    case ViewerHandTracker::Taken::Followed:
      return "the station follows the hand of this viewer";
    case ViewerHandTracker::Taken::Passing:
      return "the station does not follow the hand of this viewer yet: it followed another viewer's hand within the "
             "last 0.3 s";
    case ViewerHandTracker::Taken::OutOfReach:
      return "the station does not follow the hand of this viewer: the hand is beyond the device's reach of 0.5 m";
  }
  return "?";
}

}  // namespace telepalp::tracking
