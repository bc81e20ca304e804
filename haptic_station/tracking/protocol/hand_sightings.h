#pragma once

#include <chrono>
#include <optional>

#include "haptic_station/tracking/protocol/clock_envelope.h"
#include "proto/words/frames.h"
#include "proto/words/latest_value.h"
#include "proto/words/time.h"

namespace telepalp::tracking {

/// The newest sighting of a hand, on its way from a protocol's thread to the haptic thread, where its time becomes
/// session time. `Frame`: the frame in which the protocol tells of hands.
template <class Frame>
class Sightings {
 public:
  using Clock = std::chrono::steady_clock;
  struct Seen {
    Clock::time_point at;
    Point<Frame> hand;
  };
  struct Timed {
    SessionTime at;
    Point<Frame> hand;
  };

  /// Protocol's thread only.
  void put(Clock::time_point at, const Point<Frame>& hand) { newest_.put({at, hand}); }

  /// Haptic thread only, as all below: what has come since the last time.
  [[nodiscard]] std::optional<Seen> take() noexcept {
    return newest_.take() ? std::optional(newest_.current()) : std::nullopt;
  }
  [[nodiscard]] std::optional<Timed> take(SessionTime now) noexcept {
    (void)session_clock_.map(now.time_since_epoch(), Clock::now().time_since_epoch());
    const std::optional<Seen> seen = take();
    if (!seen) return std::nullopt;
    return Timed{SessionTime(seen->at.time_since_epoch() - session_clock_.difference()), seen->hand};
  }

 private:
  LatestValue<Seen> newest_;
  ClockEnvelope session_clock_{0.02};  // owner: haptic thread; the session's clock is slewed
};

}  // namespace telepalp::tracking
