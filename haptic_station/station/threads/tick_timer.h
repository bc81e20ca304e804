#pragma once

#include <chrono>
#include <cstdint>

#include "proto/words/time.h"

namespace telepalp::station {

/// Absolute deadlines at a fixed period. A tick that is late does not move the ones after it; a tick that has been
/// overtaken by the next deadline is missed: it is skipped and counted, so that the loop never runs in a burst.
class TickTimer {
 public:
  using Clock = std::chrono::steady_clock;

  TickTimer(Clock::time_point first, Nanoseconds period) noexcept : deadline_(first), period_(period) {}

  /// Sleeps until the next deadline (a system call, the only one of the loop besides the device's).
  struct Tick {
    Clock::time_point deadline;
    Nanoseconds late;
    std::uint64_t missed;  ///< deadlines skipped just before this one
  };
  [[nodiscard]] Tick wait() noexcept;

 private:
  Clock::time_point deadline_;
  Nanoseconds period_;
};

/// How many whole periods `late` overtakes: the deadlines that are lost. Pure, for tests.
[[nodiscard]] constexpr std::uint64_t deadlines_overtaken(Nanoseconds late, Nanoseconds period) noexcept {
  return late < period ? 0 : static_cast<std::uint64_t>(late / period);
}

}  // namespace telepalp::station
