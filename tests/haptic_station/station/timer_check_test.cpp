#include "haptic_station/station/threads/timer_check.h"

#include <gtest/gtest.h>

namespace telepalp::station {
namespace {

TEST(TimerCheck, WatchesTheTimerAtTheTicksPeriodForAsLongAsAsked) {
  const msg::TimerCheck check = watch_idle_timer(std::chrono::milliseconds(200));
  EXPECT_GE(check.seconds(), 0.2);
  EXPECT_NEAR(static_cast<double>(check.wakeups()), check.seconds() * 2000.0,
              0.1 * static_cast<double>(check.wakeups()) + 3.0);
  EXPECT_LE(check.missed(), check.wakeups());
  EXPECT_GT(check.late_us_p50(), 0.0);
  EXPECT_LE(check.late_us_p50(), check.late_us_p99());
  EXPECT_LE(check.late_us_p99(), 1.04 * check.late_us_max());
  EXPECT_EQ(check.missed() > 0, check.late_us_max() >= 500.0);
}

TEST(TimerCheck, DescribesItsResult) {
  msg::TimerCheck check;
  check.set_wakeups(2000);
  check.set_missed(4);
  check.set_late_us_p50(61.6);
  check.set_late_us_max(4100.0);
  EXPECT_EQ(in_words(check),
            "timer of this computer at 2 kHz, while idle: 4 of 2000 wake-ups missed; delay: median 62 us, "
            "largest 4100 us");
}

}  // namespace
}  // namespace telepalp::station
