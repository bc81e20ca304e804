#include "haptic_station/control/safety/virtual_tool.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/haptic_station/control/turning_path.h"

namespace telepalp::control {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

TEST(VirtualTool, NoClosedPathGivesEnergyOnADeviceThatMeasuresSixDegreesAndDrivesThree) {
  constexpr std::uint64_t kSeed = 17;
  const ClosedPaths honest = closed_paths(kSeed, 100'000, Handles::VirtualTool);
  EXPECT_GE(honest.steps, 100'000);
  EXPECT_GT(honest.felt_N, 5.0) << "the path presses on the membrane";
  EXPECT_LE(honest.gained_J, 0.0) << "seed " << kSeed;
  EXPECT_LE(honest.worst_lap_J, 1e-6) << "seed " << kSeed;
  const ClosedPaths naive = closed_paths(kSeed, 100'000, Handles::DeviceAttitude);
  EXPECT_GT(naive.gained_J, 0.01) << "without the virtual tool a free turn loads the spring";
}

TEST(VirtualTool, FollowsAFreeTurnAndRefusesOneThatLoads) {
  const effects::EffectBank bank = needle_over_membrane();
  VirtualTool tool;
  const Quaterniond tilted = turned(Quaterniond::Identity(), {1.0, 0.0, 0.0});
  tool.begin(tilted);
  effects::EffectInput in = needle_input({0.0, 0.06, 0.0});  // the tip of an upright needle would be 40 mm deep
  Quaterniond wanted = tilted;
  for (int tick = 0; tick < 2000; ++tick) {
    wanted = turned(Quaterniond::Identity(), {1.0 - 0.0005 * tick, 0.0, 0.0});
    in = tool.turn(in, wanted, bank, false, kNeedleTick_s);
  }
  const double depth_m = -(in.device.m + in.turn.attitude * kNeedleTip_m).y();
  EXPECT_LE(depth_m, 1e-6) << "turned as far as the membrane, not into it";
  EXPECT_GT(depth_m, -1e-3);
  EXPECT_FALSE(tool.shows_torque());
  for (int tick = 0; tick < 2000; ++tick) in = tool.turn(in, tilted, bank, false, kNeedleTick_s);
  EXPECT_LT(in.turn.attitude.angularDistance(tilted), 1e-6) << "turns back freely";
}

TEST(VirtualTool, HasTheDevicesAttitudeWhereTheDeviceGivesTorques) {
  const effects::EffectBank bank = needle_over_membrane();
  VirtualTool tool;
  tool.begin(Quaterniond::Identity());
  const Quaterniond tilted = turned(Quaterniond::Identity(), {0.01, 0.0, 0.0});
  const auto in = tool.turn(needle_input({0.0, 0.09, 0.0}), tilted, bank, true, kNeedleTick_s);
  EXPECT_EQ(in.turn.attitude.coeffs(), tilted.coeffs());
  EXPECT_LT((in.turn.turned.v - Vector3d(0.01, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_TRUE(tool.shows_torque());
}

/// A device of three degrees is replaced by one of six in the middle of a contact.
TEST(VirtualTool, ShowsNoTorqueUntilItHasReachedAnAttitudeThatAppearsInAContact) {
  const effects::EffectBank bank = needle_over_membrane();
  VirtualTool tool;
  tool.begin(std::nullopt);
  effects::EffectInput in = needle_input({0.0, 0.09, 0.0});  // 10 mm deep
  in = tool.turn(in, std::nullopt, bank, false, kNeedleTick_s);
  const Quaterniond tilted = turned(Quaterniond::Identity(), {0.5, 0.0, 0.0});
  in = tool.turn(in, tilted, bank, true, kNeedleTick_s);
  EXPECT_FALSE(tool.shows_torque());
  EXPECT_LE(in.turn.turned.v.norm(), 0.011) << "20 rad/s";
  for (int tick = 0; tick < 200; ++tick) in = tool.turn(in, tilted, bank, true, kNeedleTick_s);
  EXPECT_TRUE(tool.shows_torque());
  EXPECT_LT(in.turn.attitude.angularDistance(tilted), 1e-9);
  in = tool.turn(in, std::nullopt, bank, false, kNeedleTick_s);
  EXPECT_FALSE(tool.shows_torque()) << "and back to three degrees";
  EXPECT_LT(in.turn.attitude.angularDistance(tilted), 1e-9) << "the tool rests";
}

}  // namespace
}  // namespace telepalp::control
