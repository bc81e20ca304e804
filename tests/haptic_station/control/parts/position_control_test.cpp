#include "haptic_station/control/parts/position_control.h"

#include <gtest/gtest.h>

namespace telepalp::control {
namespace {

using Eigen::Vector3d;

constexpr double kTick_s = 0.0005;
constexpr double kPlane_m = 0.031;

ControlInput hand_at(const Vector3d& hand, const Vector3d& device) {
  ControlInput in;
  in.hand.m = hand;
  in.device.m = device;
  in.hand_valid = true;
  return in;
}

TEST(PositionControl, BeginsAtZeroForceWhereTheEndEffectorIs) {
  const ControlInput in = hand_at({0.05, 0.06, 0.0}, {0.0, 0.02, 0.0});
  PositionControl control({}, 0.15);
  control.begin(in, kPlane_m);
  EXPECT_LT(control.step(in, kPlane_m, kTick_s).norm(), 0.05);
  EXPECT_LT((control.target().m - in.device.m).norm(), 1e-3);
}

TEST(PositionControl, TargetEndsUnderTheHandOnThePlane) {
  const ControlInput in = hand_at({0.05, 0.06, -0.02}, {0.0, 0.02, 0.0});
  PositionControl control({}, 0.15);
  control.begin(in, kPlane_m);
  for (int tick = 0; tick < 6000; ++tick) (void)control.step(in, kPlane_m, kTick_s);
  EXPECT_NEAR((control.target().m - Vector3d(0.05, kPlane_m, -0.02)).norm(), 0.0, 1e-6);
}

TEST(PositionControl, AHandCanAlwaysHoldTheEndEffector) {
  const PositionControlSettings settings;
  const ControlInput near = hand_at({0.0, 0.06, 0.0}, {0.0, kPlane_m, 0.0});
  const ControlInput far = hand_at({0.3, 0.06, 0.0}, {0.0, kPlane_m, 0.0});
  PositionControl control(settings, 0.15);
  control.begin(near, kPlane_m);
  Vector3d before_N = Vector3d::Zero();
  for (int tick = 0; tick < 4000; ++tick) {
    const Vector3d force_N = control.step(far, kPlane_m, kTick_s);
    EXPECT_LE(force_N.norm(), settings.most_N + 1e-9);
    EXPECT_LE((force_N - before_N).norm(), 0.028 + 1e-9) << "N a tick";
    before_N = force_N;
  }
  EXPECT_GT(before_N.x(), 2.9);
}

TEST(Lift, DrivesUpwardsGentlyAndStopsAtThePlane) {
  const PositionControlSettings settings;
  const Vector3d below_N = lift_force_N(hand_at(Vector3d::Zero(), {0.0, 0.0, 0.0}), kPlane_m, settings);
  EXPECT_GT(below_N.y(), 0.9);
  EXPECT_LE(below_N.norm(), settings.lift_most_N);
  EXPECT_LT(lift_force_N(hand_at(Vector3d::Zero(), {0.0, 0.06, 0.0}), kPlane_m, settings).y(), 0.0);
}

}  // namespace
}  // namespace telepalp::control
