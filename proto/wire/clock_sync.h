#pragma once

#include <algorithm>
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

/// Session minus local time as a function of local time: `target`, or, above it, a line that falls by half. Time
/// read through it never runs backwards: a second here is at least half a second there.
struct SlewedOffset {
  Nanoseconds target{0};
  Nanoseconds line_at_zero{0};  ///< what the falling line would be at local time 0

  [[nodiscard]] Nanoseconds at(Nanoseconds local) const noexcept { return std::max(target, line_at_zero - local / 2); }
};

/// Estimates session time minus local steady time from probes. Pure: it is told what time it is.
///
/// The sample of the shortest round trip among the recent ones is believed: queueing only ever lengthens a round
/// trip, so that sample has the least room for asymmetry. Age counts against it, since crystals drift (NTP's clock
/// filter and distance, RFC 5905 §10 and §11.2.1). A correction upwards is taken at once; one downwards is slewed, so
/// that time never runs backwards; one of a second or more is another time line, and is taken at once.
class ClockSync {
 public:
  /// False: the sample contradicts itself (time ran backwards) and is dropped.
  bool add(const ClockSample& sample);

  /// Forgets the samples, as after a reconnection; the offset given out stays continuous.
  void forget_samples() noexcept { window_.clear(); }

  /// Session minus local, as given out; nullopt before the first sample.
  [[nodiscard]] const std::optional<SlewedOffset>& offset() const noexcept { return given_; }
  /// How far the estimate may be from the truth: half its round trip, and what crystals may have drifted since.
  [[nodiscard]] Nanoseconds uncertainty() const noexcept;
  /// Changes that were taken at once, after the first.
  [[nodiscard]] std::uint64_t steps() const noexcept { return steps_; }

 private:
  void drop_what_a_jump_has_outdated();
  void follow(Nanoseconds estimate, Nanoseconds local_now) noexcept;

  std::deque<ClockSample> window_;  // oldest first
  std::optional<SlewedOffset> given_;
  std::uint64_t steps_ = 0;
};

}  // namespace telepalp::wire
