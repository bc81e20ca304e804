#include "haptic_station/control/safety/force_limiter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "haptic_station/device/random.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::control {
namespace {

/// Any double: ordinary, huge, tiny, infinite or NaN.
double anything(device::Random& random) {
  switch (random.bits() % 8) {
    case 0:
      return std::numeric_limits<double>::quiet_NaN();
    case 1:
      return std::numeric_limits<double>::infinity();
    case 2:
      return -std::numeric_limits<double>::max();
    case 3:
      return std::numeric_limits<double>::denorm_min();
    case 4:
      return std::bit_cast<double>(random.bits());
    default:
      return random.uniform(-30.0, 30.0);
  }
}

TEST(ForceLimiter, AMillionArbitraryInputsNeverExceedPeakOrSlew) {
  constexpr std::uint64_t kSeed = 20240;
  SCOPED_TRACE(kSeed);
  device::Random random(kSeed);
  const ForceLimits limits;
  ForceLimiter limiter(limits);
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  double most_N = 0.0;
  Force<HapticBase> wanted;
  for (int i = 0; i < 1'000'000; ++i) {
    if (random.bits() % 4 == 0) limiter.rearm();
    if (random.bits() % 30 == 0)  // held for a while; otherwise the slew limit would keep the force below the peak
      wanted.N = {anything(random), anything(random), anything(random)};
    const Eigen::Vector3d given = limiter.limit({wanted}, kTick_s).force.N;
    most_N = std::max(most_N, given.norm());
    ASSERT_TRUE(given.allFinite()) << i;
    ASSERT_LE(given.norm(), limits.peak_N + 1e-12) << i;
    ASSERT_LE((given - before).norm(), limits.slew_N_per_s * kTick_s + 1e-12) << i;
    before = given;
  }
  EXPECT_GT(most_N, 9.9) << "or the peak was never tried";
}

TEST(ForceLimiter, AForceThatIsNotANumberReleasesAndLatches) {
  ForceLimiter limiter;
  for (int i = 0; i < 1000; ++i) (void)limiter.limit({{{0.0, 3.0, 0.0}}}, kTick_s);
  (void)limiter.limit({{{0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}}}, kTick_s);
  EXPECT_TRUE(limiter.faulted());
  Force<HapticBase> force;
  for (int i = 0; i < 100; ++i) force = limiter.limit({{{0.0, 3.0, 0.0}}}, kTick_s).force;
  EXPECT_EQ(force.N.norm(), 0.0) << "a good force does not end a latched fault";
  limiter.rearm();
  for (int i = 0; i < 1000; ++i) force = limiter.limit({{{0.0, 3.0, 0.0}}}, kTick_s).force;
  EXPECT_DOUBLE_EQ(force.N.y(), 3.0);
}

TEST(ForceLimiter, TenNewtonsAreGivenForAWhileAndFourForEver) {
  const ForceLimits limits;
  ForceLimiter limiter(limits);
  double given_N = 0.0;
  double at_peak_s = 0.0;
  for (double t = 0.0; t < 120.0; t += kTick_s) {
    given_N = limiter.limit({{{0.0, 25.0, 0.0}}}, kTick_s).force.N.y();
    if (given_N > limits.peak_N - 0.01) at_peak_s += kTick_s;
  }
  EXPECT_GT(at_peak_s, 1.0);
  EXPECT_LT(at_peak_s, 5.0);
  EXPECT_NEAR(given_N, limits.continuous_N, 0.05);
}

TEST(ForceLimiter, MotorsThatCanHoldNoForceAreGivenNone) {
  for (const double peak_N : {0.0, 10.0}) {
    ForceLimiter limiter({.peak_N = peak_N, .continuous_N = 0.0});
    for (int i = 0; i < 100; ++i) EXPECT_EQ(limiter.limit({{{0.0, 3.0, 0.0}}}, kTick_s).force.N.norm(), 0.0) << peak_N;
    EXPECT_FALSE(limiter.faulted());
    EXPECT_EQ(limiter.bound_N(), 0.0);
  }
}

TEST(ForceLimiter, AForceWithinAllBoundsPassesUntouched) {
  ForceLimiter limiter;
  for (int i = 0; i < 100; ++i) {
    const double wanted_N = 0.03 * i;
    EXPECT_DOUBLE_EQ(limiter.limit({{{0.0, wanted_N, 0.0}}}, kTick_s).force.N.y(), wanted_N);
    EXPECT_FALSE(limiter.limited());
  }
}

}  // namespace
}  // namespace telepalp::control
