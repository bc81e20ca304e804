#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>

#include "proto/words/time.h"

namespace telepalp::wire {

/// The four NTP time stamps (RFC 5905 §8) of one clock probe: two on the prober's steady clock, two on the peer's
/// session clock.
struct ClockSample {
  Nanoseconds asked;     ///< request sent, local time
  Nanoseconds received;  ///< request received, session time
  Nanoseconds replied;   ///< reply sent, session time
  Nanoseconds heard;     ///< reply received, local time

  /// Network delay of request and reply, without the peer's processing time.
  [[nodiscard]] Nanoseconds round_trip() const noexcept { return (heard - asked) - (replied - received); }
  /// Session minus local time, exact if both directions took equally long. The error is at most half the round trip.
  [[nodiscard]] Nanoseconds offset() const noexcept { return ((received - asked) + (replied - heard)) / 2; }
};

/// Session minus local time as a function of local time: the maximum of `target` and a line with slope -1/2. The slope
/// makes session time advance at least half as fast as local time, so it never runs backwards.
struct SlewedOffset {
  Nanoseconds target{0};
  Nanoseconds line_at_zero{0};  ///< value of the falling line at local time 0

  [[nodiscard]] Nanoseconds at(Nanoseconds local) const noexcept { return std::max(target, line_at_zero - local / 2); }
};

/// Estimates session time minus local steady time from probes. Pure: it reads no clock.
///
/// The network delay is never negative. So the quickest request of the last minute bounds the offset from above, the
/// quickest reply bounds it from below, and the estimate is the middle. Jitter that is alike in both directions
/// cancels. The drift of the clocks is the change of the estimate over half a minute. Samples that contradict the
/// sample with the smallest error bound are left out. An upward correction applies at once. A downward correction is
/// slewed, so that time never runs backwards, unless it is 1 s or more, as after a restart of the server: then it
/// applies at once.
class ClockSync {
 public:
  /// Adds a sample. False: the sample is inconsistent (time ran backwards) and is dropped.
  bool add(const ClockSample& sample);

  /// Discards the samples, for example after a reconnection; offset() stays continuous.
  void forget_samples() noexcept { window_.clear(); }

  /// The slewed estimate of session minus local time; nullopt before the first sample.
  [[nodiscard]] const std::optional<SlewedOffset>& offset() const noexcept { return given_; }
  /// Bound on the error of offset()->at(local_now), whether or not the path is symmetric: the bound from requests and
  /// replies, widened by an oscillator drift of 200 ppm since each sample, plus the correction that is not yet slewed.
  /// Without samples Nanoseconds::max().
  [[nodiscard]] Nanoseconds uncertainty(Nanoseconds local_now) const noexcept;
  /// Number of corrections of 1 s or more, upward or downward. The first estimate does not count.
  [[nodiscard]] std::uint64_t steps() const noexcept { return steps_; }
  /// Sum of the corrections that steps() counts; upward corrections are positive.
  [[nodiscard]] Nanoseconds stepped() const noexcept { return stepped_; }

 private:
  void drop_what_a_jump_has_outdated();
  void follow(Nanoseconds estimate, Nanoseconds local_now) noexcept;

  std::deque<ClockSample> window_;  // oldest first
  std::optional<SlewedOffset> given_;
  std::uint64_t steps_ = 0;
  Nanoseconds stepped_{0};
};

}  // namespace telepalp::wire
