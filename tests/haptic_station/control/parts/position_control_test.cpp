#include "haptic_station/control/parts/position_control.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "haptic_station/control/parts/lift.h"
#include "haptic_station/device/simulated_pair.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::control {
namespace {

using Eigen::Vector3d;

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
  control.begin(in, kPlane_m, Vector3d::Zero());
  EXPECT_LT(control.step(in, kPlane_m, kTick_s).norm(), 0.05);
  EXPECT_LT((control.target().m - in.device.m).norm(), 1e-3);
}

TEST(PositionControl, TakesOverTheForceOfTheLift) {
  const ControlInput in = hand_at({0.05, 0.06, 0.0}, {0.0, 0.02, 0.0});
  const Vector3d lifts_N{0.1, 0.8, 0.0};
  PositionControl control({}, 0.15);
  control.begin(in, kPlane_m, lifts_N);
  EXPECT_LT((control.step(in, kPlane_m, kTick_s) - lifts_N).norm(), 0.05);
}

TEST(PositionControl, TargetEndsUnderTheHandOnThePlane) {
  const ControlInput in = hand_at({0.05, 0.06, -0.02}, {0.0, 0.02, 0.0});
  PositionControl control({}, 0.15);
  control.begin(in, kPlane_m, Vector3d::Zero());
  for (int tick = 0; tick < 6000; ++tick) (void)control.step(in, kPlane_m, kTick_s);
  EXPECT_NEAR((control.target().m - Vector3d(0.05, kPlane_m, -0.02)).norm(), 0.0, 1e-6);
}

TEST(PositionControl, AHandCanAlwaysHoldTheEndEffector) {
  const PositionControlSettings settings;
  const ControlInput near = hand_at({0.0, 0.06, 0.0}, {0.0, kPlane_m, 0.0});
  const ControlInput far = hand_at({0.3, 0.06, 0.0}, {0.0, kPlane_m, 0.0});
  PositionControl control(settings, 0.15);
  control.begin(near, kPlane_m, Vector3d::Zero());
  Vector3d before_N = Vector3d::Zero();
  for (int tick = 0; tick < 4000; ++tick) {
    const Vector3d force_N = control.step(far, kPlane_m, kTick_s);
    EXPECT_LE(force_N.norm(), settings.most_N + 1e-9);
    EXPECT_LE((force_N - before_N).norm(), 0.045 + 1e-9) << "N a tick";
    before_N = force_N;
  }
  EXPECT_GT(before_N.x(), 2.9);
}

/// A free device whose force comes `delay_ticks` late.
struct FreeDevice {
  device::SimulatedDeviceSettings settings;
  std::size_t delay_ticks = 0;
};

/// Widest motion along x [m], from 6 s to 9 s, of a free device under a hand that stops at once after 0.3 s at
/// `hand_m_per_s`.
double motion_at_rest_m(const FreeDevice& free, double hand_m_per_s) {
  device::SimulatedPair pair(free.settings, {});
  pair.place({{0.0, kPlane_m, 0.0}}, {{0.0, 1.0, 0.0}});  // no hand touches the device
  PositionControl control({}, 0.15);
  control.begin(hand_at({0.0, 0.06, 0.0}, pair.device().m), kPlane_m, Vector3d::Zero());
  std::array<Force<HapticBase>, 16> late{};
  double least_m = 1.0, most_m = -1.0;
  for (std::size_t tick = 0; tick < 18'000; ++tick) {
    const double time_s = static_cast<double>(tick) * kTick_s;
    const bool moves = time_s < 0.3;
    ControlInput in = hand_at({hand_m_per_s * std::min(time_s, 0.3), 0.06, 0.0}, pair.device().m);
    in.device_velocity = pair.device_velocity();
    in.hand_velocity.v.x() = moves ? hand_m_per_s : 0.0;
    late[tick % late.size()] = {control.step(in, kPlane_m, kTick_s)};
    pair.step(late[(tick + late.size() - free.delay_ticks) % late.size()], {{{0.0, 1.0, 0.0}}, {}}, kTick_s);
    if (time_s < 6.0) continue;
    least_m = std::min(least_m, pair.true_device().m.x());
    most_m = std::max(most_m, pair.true_device().m.x());
  }
  return most_m - least_m;
}

TEST(PositionControl, AFreeDeviceComesToRestUnderAHandThatStops) {
  for (const double mass_kg : {0.1, 0.3, 1.0})
    for (const double b : {0.3, 1.0, 3.0})
      for (const double encoder_m : {0.13e-6, 100e-6})
        for (const std::size_t delay_ticks : {0, 8})
          for (const double hand_m_per_s : {0.1, 0.5, 1.0}) {
            const FreeDevice free{{.mass_kg = mass_kg, .damping_N_s_per_m = b, .encoder_step_m = encoder_m},
                                  delay_ticks};
            EXPECT_LT(motion_at_rest_m(free, hand_m_per_s), 0.5e-3)
                << mass_kg << " kg, " << b << " N s/m, encoders of " << 1e6 * encoder_m << " um, force " << delay_ticks
                << " ticks late, hand at " << hand_m_per_s << " m/s";
          }
}

constexpr int kSoon_ticks = 100;

Vector3d lifts_N(const ControlInput& in, Lift lift = Lift({})) {
  Vector3d force_N = Vector3d::Zero();
  for (int tick = 0; tick < kSoon_ticks; ++tick) {
    const Vector3d before_N = std::exchange(force_N, lift.step(in, kPlane_m, kTick_s));
    EXPECT_LE((force_N - before_N).norm(), 0.045 + 1e-9) << "N a tick";
  }
  return force_N;
}

TEST(Lift, DrivesUpwardsGentlyAndStopsAtThePlane) {
  const PositionControlSettings settings;
  const Vector3d below_N = lifts_N(hand_at({0.0, 0.1, 0.0}, {0.0, 0.0, 0.0}));
  EXPECT_GT(below_N.y(), 0.9);
  EXPECT_LE(below_N.norm(), settings.lift_most_N);
  EXPECT_LT(lifts_N(hand_at({0.0, 0.1, 0.0}, {0.0, 0.06, 0.0})).y(), 0.0);
}

TEST(Lift, HardlyOpposesAHandAtTheEndEffectorOrOnItsWayToIt) {
  const double most_N = PositionControlSettings{}.against_hand_N + 1e-9;
  EXPECT_LE(lifts_N(hand_at({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0})).norm(), most_N);
  ControlInput near = hand_at({0.0, 0.03, 0.0}, {0.0, 0.0, 0.0});
  EXPECT_GT(lifts_N(near).y(), 0.9) << "a hand that rests 3 cm over the end-effector";
  near.hand_velocity.v.y() = -0.6;
  EXPECT_LE(lifts_N(near).norm(), most_N);
  near.hand.m.x() = 0.1;
  EXPECT_GT(lifts_N(near).y(), 0.9) << "a hand that comes down beside the end-effector";
}

TEST(PositionControl, HardlyOpposesAHandThatPushesTheEndEffectorDown) {
  const PositionControlSettings settings;
  PositionControl control(settings, 0.15);
  ControlInput in = hand_at({0.0, kPlane_m, 0.0}, {0.0, kPlane_m, 0.0});
  control.begin(in, kPlane_m, {0.0, settings.against_hand_N, 0.0});
  for (int tick = 0; tick < kSoon_ticks; ++tick) {
    in.device_velocity.v.y() = in.hand_velocity.v.y() = -0.6;
    in.device.m.y() = in.hand.m.y() = kPlane_m - 0.6 * kTick_s * tick;
    EXPECT_LE(control.step(in, kPlane_m, kTick_s).y(), settings.against_hand_N + 1e-9) << "tick " << tick;
  }
  in.hand.m.y() = 0.2;  // without a hand, the end-effector is driven back
  in.device_velocity.v.y() = in.hand_velocity.v.y() = 0.0;
  for (int tick = 0; tick < kSoon_ticks; ++tick) (void)control.step(in, kPlane_m, kTick_s);
  EXPECT_GT(control.step(in, kPlane_m, kTick_s).y(), 2.0);
}

}  // namespace
}  // namespace telepalp::control
