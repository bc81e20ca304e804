#pragma once

#include <chrono>
#include <cstdint>

#include "proto/words/time.h"

namespace telepalp::station {

/// Absolute deadlines at a fixed period. A late tick does not move later deadlines. A deadline is missed if wait()
/// returns a period or more after it; it is then skipped and counted, so that ticks never run in a burst.
class TickTimer {
 public:
  using Clock = std::chrono::steady_clock;

  TickTimer(Clock::time_point first, Nanoseconds period) noexcept : deadline_(first), period_(period) {}

  /// One tick: its deadline, and the delay from its deadline to the return of wait().
  struct Tick {
    Clock::time_point deadline;
    Nanoseconds late;
    std::uint64_t missed;  ///< deadlines skipped just before this one
  };
  /// Sleeps until the next deadline. The 2 kHz loop makes no other system call but those of the rig.
  [[nodiscard]] Tick wait() noexcept;

 private:
  Clock::time_point deadline_;
  Nanoseconds period_;
};

/// Number of deadlines missed by a wake-up `late` after its deadline: the whole periods in `late`. Pure, for tests.
[[nodiscard]] constexpr std::uint64_t deadlines_overtaken(Nanoseconds late, Nanoseconds period) noexcept {
  return late < period ? 0 : static_cast<std::uint64_t>(late / period);
}

}  // namespace telepalp::station
