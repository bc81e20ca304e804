#pragma once

#include <chrono>
#include <cstdint>

#include "proto/words/time.h"

namespace telepalp::station {

/// Absolute deadlines at a fixed period. A late tick does not move later deadlines. A deadline is missed if its tick
/// could start only one period later or more: it is skipped and counted, so that the loop never runs in a burst.
class TickTimer {
 public:
  using Clock = std::chrono::steady_clock;

  TickTimer(Clock::time_point first, Nanoseconds period) noexcept : deadline_(first), period_(period) {}

  /// One tick of the timer: its deadline and its delay.
  struct Tick {
    Clock::time_point deadline;
    Nanoseconds late;
    std::uint64_t missed;  ///< deadlines skipped just before this one
  };
  /// Sleeps until the next deadline. It is the loop's only system call besides the device's.
  [[nodiscard]] Tick wait() noexcept;

 private:
  Clock::time_point deadline_;
  Nanoseconds period_;
};

/// Number of whole periods in `late`: the deadlines that were missed. Pure, for tests.
[[nodiscard]] constexpr std::uint64_t deadlines_overtaken(Nanoseconds late, Nanoseconds period) noexcept {
  return late < period ? 0 : static_cast<std::uint64_t>(late / period);
}

}  // namespace telepalp::station
