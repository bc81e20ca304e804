#include "haptic_station/control/parts/force_control.h"

#include <gtest/gtest.h>

#include "tests/haptic_station/periods.h"

namespace telepalp::control {
namespace {

constexpr double kForceBound_N = 10.0;

ForceControl over_a_skin_of(double stiffness_N_per_m) {
  effects::EffectBank bank;
  (void)bank.add(effects::Skin({.law = effects::linear_law(stiffness_N_per_m)}));
  return {bank, {}, kForceBound_N};
}

ControlInput at_height(double height_m) {
  ControlInput in;
  in.device.m.y() = height_m;
  in.contact.valid = true;
  in.contact.in_body = height_m < 0.0;
  in.contact.normal.v = Eigen::Vector3d::UnitY();
  in.contact.distance_m = height_m;
  return in;
}

/// Presses from the skin down to `depth_m` at 0.1 m/s.
Eigen::Vector3d pressed_to(ForceControl& control, double depth_m) {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  for (double at_m = 0.0; at_m < depth_m; at_m += 5e-5)
    force_N = control.step(at_height(-at_m), true, kForceBound_N, 0.0, kTick_s).force.N;
  return force_N;
}

TEST(ForceControl, ShowsTheLawOfTheSkin) {
  ForceControl control = over_a_skin_of(300.0);
  EXPECT_NEAR(pressed_to(control, 0.01).y(), 3.0, 0.02);
  EXPECT_NEAR(control.indentation().v.y(), -0.01, 1e-4);
}

TEST(ForceControl, GivesNothingWithoutContact) {
  ForceControl control = over_a_skin_of(300.0);
  (void)pressed_to(control, 0.01);
  EXPECT_EQ(control.step(at_height(0.001), false, kForceBound_N, 0.0, kTick_s).force.N, Eigen::Vector3d::Zero());
  EXPECT_TRUE(control.contact_changed());
  EXPECT_FALSE(control.touching());
  EXPECT_EQ(control.indentation().v, Eigen::Vector3d::Zero());
}

TEST(ForceControl, AContactThatBeginsAtDepthBeginsWithoutForce) {
  ForceControl control = over_a_skin_of(300.0);
  constexpr double kRise_m = 0.1 * kTick_s;  // of the body, in the first tick
  EXPECT_LE(control.step(at_height(-0.02), true, kForceBound_N, 0.0, kTick_s).force.N.norm(), 300.0 * kRise_m + 1e-9);
  EXPECT_NEAR(control.shown().distance_m, 0.0, 1e-4);
}

TEST(ForceControl, ReleasesAContactSlowlyAndTakesItUpAgain) {
  ForceControl control = over_a_skin_of(300.0);
  (void)pressed_to(control, 0.01);
  for (int tick = 0; tick < 2000; ++tick) control.release(true, 2.0, kTick_s);
  EXPECT_NEAR(control.step(at_height(-0.01), true, kForceBound_N, 0.0, kTick_s).force.N.y(), 1.5, 0.02)
      << "half of 2 s";
  EXPECT_FALSE(control.released());
  for (int tick = 0; tick < 2100; ++tick) control.release(true, 2.0, kTick_s);
  EXPECT_TRUE(control.released());
  for (int tick = 0; tick < 4100; ++tick) control.release(false, 2.0, kTick_s);
  EXPECT_NEAR(control.step(at_height(-0.01), true, kForceBound_N, 0.0, kTick_s).force.N.y(), 3.0, 0.02);
}

TEST(ForceControl, TheLedgerAtTheHandSeesThatTheMeasuredSkinHasGone) {
  ForceControl control = over_a_skin_of(300.0);
  (void)pressed_to(control, 0.01);
  const double before_J = control.hand_ledger().excess_J();
  // The displayed skin stays, the measured one is 10 mm lower. The hand comes out against a force of 3 N to 0.
  for (double at_m = 0.01; at_m > 0.0; at_m -= 5e-5) {
    ControlInput in = at_height(-at_m);
    in.contact.measured_above_m = -0.01;
    const Eigen::Vector3d force_N = control.step(in, true, kForceBound_N, 0.0, kTick_s).force.N;
    control.gave({.skin = force_N}, {{force_N}});
  }
  EXPECT_NEAR(control.hand_ledger().excess_J() - before_J, 0.5 * 300.0 * 0.01 * 0.01, 1e-3);
}

/// Round the paper's cylinder, in over its top and out over its rim. With the skin, it asks for up to 19 N.
TEST(ForceControl, NoEnergyComesFromEffectsThatAskForMoreThanTheDeviceGives) {
  effects::EffectBank bank;
  (void)bank.add(effects::Skin{});
  (void)bank.add(effects::InnerCylinder({.top_center = {{0.0, -0.03, 0.0}}}));
  ForceControl control(bank, {}, kForceBound_N);
  const Eigen::Vector3d lap[] = {
      {0.005, -1e-5, 0.0}, {0.005, -0.055, 0.0}, {0.045, -0.055, 0.0}, {0.045, -1e-5, 0.0}, {0.005, -1e-5, 0.0}};
  double most_N = 0.0;
  for (int corner = 1; corner < 5; ++corner)
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d device_m = lap[corner - 1] + (lap[corner] - lap[corner - 1]) * i / 2000.0;
      ControlInput in = at_height(device_m.y());
      in.device.m = device_m;
      in.contact.proxy.m = {device_m.x(), 0.0, device_m.z()};
      in.device_velocity.v = (lap[corner] - lap[corner - 1]) / (2000.0 * kTick_s);
      const Eigen::Vector3d force_N = control.step(in, true, kForceBound_N, 0.0, kTick_s).force.N;
      control.gave({.skin = force_N}, {{force_N}});
      most_N = std::max(most_N, force_N.norm());
    }
  EXPECT_GE(most_N, kForceBound_N - 1e-6);
  EXPECT_GE(control.passivity().least_balance_J(), -2e-3);
}

TEST(ForceControl, StiffSkinIsMetThroughTheCoupling) {
  ForceControl control = over_a_skin_of(20'000.0);
  ASSERT_TRUE(control.coupling().engaged());
  const double most_N = control.coupling().stiffness_N_per_m() * 0.002;
  EXPECT_LE(pressed_to(control, 0.002).y(), most_N);
}

}  // namespace
}  // namespace telepalp::control
