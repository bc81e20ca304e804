#include "haptic_station/control/parts/heat_warning.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/haptic_station/periods.h"

namespace telepalp::control {
namespace {

TEST(HeatWarning, VibratesSecondsBeforeTheForceFallsAndNeverSteps) {
  ForceLimiter limiter;
  HeatWarning warning;
  const Eigen::Vector3d push_N(0.0, 5.0, 0.0);
  double warned_s = 0.0;
  double falls_s = 0.0;
  Eigen::Vector3d before_N = Eigen::Vector3d::Zero();
  for (int tick = 0; tick < 60'000 && falls_s == 0.0; ++tick) {
    const Eigen::Vector3d cue_N = warning.step(push_N, limiter, kTick_s);
    EXPECT_LE((cue_N - before_N).norm(), 0.05);
    before_N = cue_N;
    if (warned_s == 0.0 && cue_N.norm() > 0.1) warned_s = tick * kTick_s;
    (void)limiter.limit({{push_N + cue_N}}, kTick_s);
    if (limiter.bound_N() < 5.0) falls_s = tick * kTick_s;
  }
  EXPECT_GT(warned_s, 0.0);
  EXPECT_GT(falls_s - warned_s, 3.0);
}

/// A contact begins while the motors are still warm. Its first forces are faint, and their direction turns.
TEST(HeatWarning, AFaintForceThatTurnsRoundDoesNotMakeItStep) {
  ForceLimiter limiter;
  HeatWarning warning;
  const Eigen::Vector3d push_N(0.0, 5.0, 0.0);
  int tick = 0;
  for (double cue_N = 0.0; tick < 60'000 && cue_N < 0.1; ++tick) {
    cue_N = warning.step(push_N, limiter, kTick_s).norm();
    (void)limiter.limit({{push_N}}, kTick_s);
  }
  ASSERT_LT(tick, 60'000);
  Eigen::Vector3d before_N = warning.step({0.01, 0.0, 0.0}, limiter, kTick_s);
  for (tick = 0; tick < 100; ++tick) {
    const Eigen::Vector3d turns(std::cos(0.5 * tick), std::sin(0.5 * tick), 0.0);
    const Eigen::Vector3d cue_N = warning.step(0.01 * turns, limiter, kTick_s);
    ASSERT_LE((cue_N - before_N).norm(), 0.005);
    before_N = cue_N;
  }
}

TEST(HeatWarning, IsSilentWhileTheForceCanBeHeldForEver) {
  ForceLimiter limiter;
  HeatWarning warning;
  const Eigen::Vector3d push_N(0.0, 3.9, 0.0);
  for (int tick = 0; tick < 200'000; ++tick) {
    ASSERT_EQ(warning.step(push_N, limiter, kTick_s).norm(), 0.0);
    (void)limiter.limit({{push_N}}, kTick_s);
  }
  EXPECT_TRUE(std::isinf(warning.yields_in_s()));
}

TEST(HeatWarning, TheForceYieldsSlowly) {
  ForceLimiter limiter;
  double fastest_N_per_s = 0.0;
  double before_N = 9.0;
  for (int tick = 0; tick < 120'000; ++tick) {
    const double given_N = limiter.limit({{{0.0, 9.0, 0.0}}}, kTick_s).force.N.norm();
    if (tick > 100) fastest_N_per_s = std::max(fastest_N_per_s, (before_N - given_N) / kTick_s);
    before_N = given_N;
  }
  EXPECT_LT(fastest_N_per_s, 3.0);
  EXPECT_NEAR(before_N, 4.0, 0.1);
}

}  // namespace
}  // namespace telepalp::control
