#include "haptic_station/device/simulated_pair.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/haptic_station/periods.h"

namespace telepalp::device {
namespace {

TEST(SimulatedPair, AHandAtRestHoldsTheDeviceAgainstAForceItFeels) {
  SimulatedPair pair({}, {});
  pair.place({{0.0, 0.0, 0.0}}, {{0.0, 0.0, 0.0}});
  for (int i = 0; i < 8000; ++i) pair.step({{0.5, 2.0, 0.0}}, {}, kTick_s);
  EXPECT_NEAR(pair.felt().N.y(), 2.0, 0.01);
  EXPECT_NEAR(pair.felt().N.x(), 0.5, 0.01);
  EXPECT_NEAR(pair.true_hand().m.y(), 2.0 / 300.0, 1e-4) << "it yields by force over its stiffness";
  EXPECT_LT(pair.true_device_velocity().v.norm(), 1e-4);
}

TEST(SimulatedPair, TheHandPushesAndNeverPulls) {
  SimulatedPair pair({}, {});
  pair.place({{0.0, 0.0, 0.0}}, {{0.0, 0.0, 0.0}});
  for (int i = 0; i < 4000; ++i) {
    pair.step({}, {.at = {{0.0, 0.1, 0.0}}, .velocity = {}}, kTick_s);
    ASSERT_GE(pair.felt().N.y(), 0.0);
  }
  EXPECT_NEAR(pair.true_hand().m.y(), 0.1, 0.001);
  EXPECT_LT(pair.true_device().m.y(), 0.01) << "left behind";
}

TEST(SimulatedPair, AHandThatComesFromTheSideBelowDoesNotSeizeTheDevice) {
  SimulatedPair pair({}, {});
  pair.place({{0.0, 0.0, 0.0}}, {{0.2, 0.05, 0.0}});
  for (int i = 0; i < 2000; ++i) pair.step({}, {.at = {{0.2, -0.05, 0.0}}, .velocity = {}}, kTick_s);
  for (int i = 0; i < 2000; ++i) pair.step({}, {.at = {{0.0, -0.05, 0.0}}, .velocity = {}}, kTick_s);
  EXPECT_LT(pair.true_hand().m.x(), 0.03) << "it is under the end-effector";
  EXPECT_EQ(pair.true_device().m.norm(), 0.0);
}

TEST(SimulatedPair, AHandThatComesDownInJerksPushesTheDeviceAllTheWay) {
  SimulatedPair pair({}, {});
  pair.place({{0.0, 0.03, 0.0}}, {{0.0, 0.05, 0.0}});
  for (int jerk = 0; jerk < 100; ++jerk) {
    const double height_m = std::max(-0.04, 0.05 - 0.006 * jerk);  // steps of 60 ms, as from a slow browser
    for (int i = 0; i < 120; ++i) pair.step({}, {.at = {{0.0, height_m, 0.0}}, .velocity = {}}, kTick_s);
  }
  EXPECT_LT(pair.true_device().m.y(), -0.03);
}

TEST(SimulatedPair, FleshSlipsWhenPushedSidewaysTooHard) {
  SimulatedPair pair({}, {});
  pair.place({{0.0, 0.0, 0.0}}, {{0.0, 0.0, 0.0}});
  for (int i = 0; i < 4000; ++i) {
    pair.step({{3.0, 1.0, 0.0}}, {}, kTick_s);
    ASSERT_LE(std::abs(pair.felt().N.x()), 0.8 * pair.felt().N.y() + 1e-9) << i;
  }
  EXPECT_GT(pair.true_device().m.x(), pair.true_hand().m.x() + 0.005);
}

TEST(SimulatedPair, StaysFiniteAtEveryStiffness) {
  for (const double stiffness : {1.0, 1e3, 1e6, 1e9}) {
    SimulatedHandSettings hand;
    hand.stiffness_N_per_m = stiffness;
    hand.pad_stiffness_N_per_m = stiffness;
    SimulatedPair pair({}, hand);
    pair.place({{0.0, 0.0, 0.0}}, {{0.0, 0.001, 0.0}});
    for (int i = 0; i < 20'000; ++i) pair.step({{0.0, 4.0, 1.0}}, {.at = {{0.0, -0.02, 0.0}}, .velocity = {}}, kTick_s);
    EXPECT_LT(pair.true_device().m.norm(), 1000.0) << stiffness;
    EXPECT_LT(pair.true_hand().m.norm(), 1.0) << stiffness;
  }
}

TEST(SimulatedPair, TheMotorsGiveNoMoreThanTheyHaveAndNothingForNonsense) {
  SimulatedPair pair({.damping_N_s_per_m = 0.0}, {});
  pair.place({{0.0, 0.0, 0.0}}, {{0.0, 1.0, 0.0}});
  pair.step({{0.0, -1e9, 0.0}}, {.at = {{0.0, 1.0, 0.0}}, .velocity = {}}, kTick_s);
  EXPECT_TRUE(pair.saturated());
  EXPECT_NEAR(pair.true_device_velocity().v.y(), -10.0 / 0.3 * kTick_s, 1e-9);
  pair.step({{0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}}, {.at = {{0.0, 1.0, 0.0}}, .velocity = {}}, kTick_s);
  EXPECT_TRUE(pair.true_device().m.allFinite());
}

TEST(SimulatedPair, EncodersStep) {
  SimulatedPair pair({.encoder_step_m = 0.001}, {});
  pair.place({{0.00149, 0.0, 0.0}}, {{0.0, 1.0, 0.0}});
  EXPECT_DOUBLE_EQ(pair.device().m.x(), 0.001);
}

}  // namespace
}  // namespace telepalp::device
