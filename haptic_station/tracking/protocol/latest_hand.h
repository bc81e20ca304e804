#pragma once

#include <chrono>
#include <optional>
#include <variant>

#include "proto/words/clock_envelope.h"
#include "proto/words/frames.h"
#include "proto/words/latest_value.h"
#include "proto/words/time.h"

namespace telepalp::tracking {

/// Hands the newest hand position and attitude from a protocol thread to the haptic thread and converts their time
/// stamp to session time. `Frame`: the frame of reference of the positions. `More`: what else the tracker reports.
template <class Frame, class More = std::monostate>
class LatestHand {
 public:
  using Clock = std::chrono::steady_clock;
  struct Seen {
    Clock::time_point at;
    Point<Frame> hand;
    std::optional<Eigen::Quaterniond> attitude;  ///< hand's axes to Frame; nullopt: the tracker reported none
    More more;
  };
  struct Timed {
    SessionTime at;
    Point<Frame> hand;
    std::optional<Eigen::Quaterniond> attitude;
    More more;
  };

  /// Protocol thread only.
  void put(Clock::time_point at, const Point<Frame>& hand,
           const std::optional<Eigen::Quaterniond>& attitude = std::nullopt, const More& more = {}) {
    newest_.put({at, hand, attitude, more});
  }

  /// The newest position put since the last take(); nullopt: none. Both take() functions: haptic thread only.
  [[nodiscard]] std::optional<Seen> take() noexcept {
    return newest_.take() ? std::optional(newest_.current()) : std::nullopt;
  }
  /// `steady`: the steady clock's time at `now`.
  [[nodiscard]] std::optional<Timed> take(SessionTime now, Clock::time_point steady = Clock::now()) noexcept {
    (void)session_clock_.map(now.time_since_epoch(), steady.time_since_epoch());
    const std::optional<Seen> seen = take();
    if (!seen) return std::nullopt;
    return Timed{SessionTime(seen->at.time_since_epoch() - session_clock_.difference()), seen->hand, seen->attitude,
                 seen->more};
  }

 private:
  LatestValue<Seen> newest_;
  ClockEnvelope session_clock_{0.02};  // owner: haptic thread; drift up to 2 %: the session clock is slewed
};

}  // namespace telepalp::tracking
