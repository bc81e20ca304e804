#include "haptic_station/station/telemetry/image_ages.h"

#include <gtest/gtest.h>

#include "haptic_station/station/threads/tick_timer.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

msg::SurfaceReport touchable_after(std::chrono::milliseconds age) {
  msg::SurfaceReport report;
  report.set_captured_ns(1'000'000'000);
  report.set_touchable_ns(1'000'000'000 + static_cast<std::uint64_t>(std::chrono::nanoseconds(age).count()));
  return report;
}

TEST(ImageAges, AreToldWithTheLargestErrorBoundOfTheSessionClock) {
  ImageAges ages;
  EXPECT_EQ(ages.in_words(), "") << "no image";
  for (int i = 0; i < 98; ++i) ages.add(touchable_after(60ms), 0.003);
  ages.add(touchable_after(120ms), 0.0032);
  ages.add(touchable_after(120ms), 0.001);
  EXPECT_EQ(ages.in_words(),
            "100 images: their surfaces were touchable 61 ms (median) and 122 ms (99th percentile) after capture; the "
            "error of both is at most 3.2 ms");
}

TEST(ImageAges, AnUnknownClockIsToldAndAnAgeBelowZeroCountsAsZero) {
  ImageAges ages;
  ages.add(touchable_after(-2ms), std::numeric_limits<double>::infinity());
  EXPECT_EQ(ages.in_words(),
            "1 image: its surface was touchable 0.0 ms (median) and 0.0 ms (99th percentile) after capture; the "
            "error of both is unknown, because the server's clock is not known");
}

TEST(TickTimer, ADeadlineIsMissedOnlyWhenTheNextOneHasPassed) {
  EXPECT_EQ(deadlines_overtaken(499us, 500us), 0u);
  EXPECT_EQ(deadlines_overtaken(500us, 500us), 1u);
  EXPECT_EQ(deadlines_overtaken(5ms, 500us), 10u);
}

TEST(TickTimer, DeadlinesStayOnTheirGridWhenTicksAreLate) {
  const auto start = TickTimer::Clock::now();
  TickTimer timer(start, 500us);
  for (int i = 0; i < 40; ++i) EXPECT_EQ((timer.wait().deadline - start) % 500us, 0ns);
}

}  // namespace
}  // namespace telepalp::station
