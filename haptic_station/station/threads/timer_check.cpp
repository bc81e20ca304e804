#include "haptic_station/station/threads/timer_check.h"

#include <algorithm>
#include <cstdio>
#include <thread>

#include "haptic_station/core/outbox/duration_histogram.h"
#include "haptic_station/station/threads/haptic_thread.h"
#include "haptic_station/station/threads/tick_timer.h"

namespace telepalp::station {
namespace {

using Clock = TickTimer::Clock;

/// Runs on the thread that waits.
msg::TimerCheck watch(std::chrono::milliseconds length) {
  core::DurationHistogram late;
  Nanoseconds latest{0};
  std::uint64_t missed = 0;
  const Clock::time_point start = Clock::now();
  TickTimer timer(start + loop::kTickPeriod, loop::kTickPeriod);
  while (Clock::now() < start + length) {
    const TickTimer::Tick tick = timer.wait();
    const Nanoseconds lateness = tick.late + loop::kTickPeriod * static_cast<Nanoseconds::rep>(tick.missed);
    late.add(static_cast<std::uint64_t>(std::max<Nanoseconds::rep>(lateness.count(), 0)));
    latest = std::max(latest, lateness);
    missed += tick.missed;
  }
  msg::TimerCheck check;
  check.set_seconds(std::chrono::duration<double>(Clock::now() - start).count());
  check.set_wakeups(late.total() + missed);
  check.set_missed(missed);
  check.set_late_us_p50(late.quantile_ns(0.5) * 1e-3);
  check.set_late_us_p99(late.quantile_ns(0.99) * 1e-3);
  check.set_late_us_max(static_cast<double>(latest.count()) * 1e-3);
  return check;
}

}  // namespace

msg::TimerCheck watch_idle_timer(std::chrono::milliseconds length) {
  msg::TimerCheck check;
  std::thread([&] {
    (void)enter_realtime(Realtime::Prefer);
    check = watch(length);
  }).join();
  return check;
}

std::string in_words(const msg::TimerCheck& check) {
  char text[200];
  std::snprintf(text, sizeof text,
                "timer of this computer at 2 kHz, while idle: %llu of %llu wake-ups missed; delay: median %.0f us, "
                "largest %.0f us",
                static_cast<unsigned long long>(check.missed()), static_cast<unsigned long long>(check.wakeups()),
                check.late_us_p50(), check.late_us_max());
  return text;
}

}  // namespace telepalp::station
