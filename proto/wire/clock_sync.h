#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "proto/words/time.h"

namespace telepalp::wire {

/// NTP's four stamps of one probe: two of the prober's steady clock, two of the peer's session clock.
struct ClockSample {
  Nanoseconds asked;     ///< local
  Nanoseconds received;  ///< session
  Nanoseconds replied;   ///< session
  Nanoseconds heard;     ///< local

  /// Time on the way, both ways, without the peer's own delay.
  [[nodiscard]] Nanoseconds round_trip() const noexcept { return (heard - asked) - (replied - received); }
  /// Session minus local if both ways took equally long; the truth lies within half a round trip of it.
  [[nodiscard]] Nanoseconds offset() const noexcept { return ((received - asked) + (replied - heard)) / 2; }
};

/// Estimates session time minus local steady time from probes. Pure: it is told what time it is.
///
/// The sample of the shortest round trip among the recent ones is believed: queueing only ever lengthens a round
/// trip, so that sample has the least room for asymmetry (NTP's clock filter, RFC 5905 §10). The offset given
/// out never turns time back: it falls by at most half of the local time that has passed. Two things end a
/// session's time line and are taken at once: a change of a second or more, and the first sample.
class ClockSync {
 public:
  /// False: the sample contradicts itself (time ran backwards) and is dropped.
  bool add(const ClockSample& sample);

  /// Forgets the samples, as after a reconnection; the offset given out stays continuous.
  void forget_samples() noexcept { window_.clear(); }

  /// Session minus local, as given out; nullopt before the first sample.
  [[nodiscard]] std::optional<Nanoseconds> offset() const noexcept { return given_; }
  /// The truth is this near the estimate, drift aside: half the best round trip.
  [[nodiscard]] Nanoseconds uncertainty() const noexcept;
  /// Changes that were taken at once, after the first.
  [[nodiscard]] std::uint64_t steps() const noexcept { return steps_; }

 private:
  [[nodiscard]] const ClockSample& best() const noexcept;
  void drop_what_a_jump_has_outdated();
  void follow(Nanoseconds estimate, Nanoseconds local_now) noexcept;

  std::deque<ClockSample> window_;  // oldest first
  std::optional<Nanoseconds> given_;
  Nanoseconds given_at_{0};  // local
  std::uint64_t steps_ = 0;
};

}  // namespace telepalp::wire
