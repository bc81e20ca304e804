#include "haptic_station/loop/loop_delay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace telepalp::loop {
namespace {

ports::DeviceReading echo(double loop_s, double age_s = 0.0) {
  ports::DeviceReading reading;
  reading.age_s = age_s;
  reading.loop_s = loop_s;
  return reading;
}

TEST(LoopDelay, IsTheDelayOfADeviceThatIsAlwaysEquallyLate) {
  for (const double delay_s : {0.0, 0.0005, 0.001, 0.002, 0.004}) {
    LoopDelay delay;
    for (int i = 0; i < 99; ++i) delay.add(echo(delay_s));
    EXPECT_FALSE(delay.p99_s()) << "too few";
    for (int i = 0; i < 5000; ++i) delay.add(echo(delay_s));
    ASSERT_TRUE(delay.p99_s());
    EXPECT_NEAR(*delay.p99_s(), delay_s, 1e-9);
  }
}

TEST(LoopDelay, IsThe99thPercentileOfTheSortedValues) {
  std::mt19937_64 random(11);
  std::lognormal_distribution<double> delays(-6.9, 0.5);
  LoopDelay delay;
  std::vector<double> all;
  for (int i = 0; i < 3900; ++i) {
    all.push_back(delays(random));
    delay.add(echo(all.back()));
  }
  std::sort(all.begin(), all.end());
  EXPECT_NEAR(*delay.p99_s(), all[3861], 60e-6);
}

TEST(LoopDelay, FollowsAChangeWithinTwoSeconds) {
  LoopDelay delay;
  for (int i = 0; i < 4000; ++i) delay.add(echo(0.004));
  for (int i = 0; i < 100; ++i) delay.add(echo(0.006));
  EXPECT_NEAR(*delay.p99_s(), 0.006, 1e-6) << "a longer delay counts soon";
  for (int i = 0; i < 4000; ++i) delay.add(echo(0.001));
  EXPECT_NEAR(*delay.p99_s(), 0.001, 1e-6);
}

TEST(LoopDelay, CountsNeitherSilenceNorWhatIsNoNumber) {
  LoopDelay delay;
  for (int i = 0; i < 500; ++i) delay.add(echo(0.001));
  for (int i = 0; i < 500; ++i) delay.add(echo(0.05, 0.02));  // the device is silent
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity(), -1.0})
    for (int i = 0; i < 500; ++i) delay.add(echo(wrong));
  for (int i = 0; i < 500; ++i) delay.add({});
  for (int i = 0; i < 100; ++i) delay.add(echo(0.001));
  EXPECT_NEAR(*delay.p99_s(), 0.001, 1e-6);
  for (int i = 0; i < 500; ++i) delay.add(echo(10.0));
  EXPECT_NEAR(*delay.p99_s(), 10.0, 1e-3) << "longer than every bin";
}

}  // namespace
}  // namespace telepalp::loop
