#include "haptic_station/station/threads/tick_timer.h"

#include <time.h>

#include <cerrno>

namespace telepalp::station {
namespace {

timespec to_timespec(TickTimer::Clock::time_point at) noexcept {
  const std::int64_t ns = std::chrono::duration_cast<Nanoseconds>(at.time_since_epoch()).count();
  return {.tv_sec = static_cast<time_t>(ns / 1'000'000'000), .tv_nsec = static_cast<long>(ns % 1'000'000'000)};
}

}  // namespace

TickTimer::Tick TickTimer::wait() noexcept {
  const timespec until = to_timespec(deadline_);
  // steady_clock is CLOCK_MONOTONIC on Linux. After a signal the sleep continues.
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
  const Nanoseconds late = Clock::now() - deadline_;
  const std::uint64_t missed = deadlines_overtaken(late, period_);
  deadline_ += period_ * static_cast<Nanoseconds::rep>(missed);
  const Tick tick{deadline_, late - period_ * static_cast<Nanoseconds::rep>(missed), missed};
  deadline_ += period_;
  return tick;
}

}  // namespace telepalp::station
