#include <gtest/gtest.h>

#include "haptic_station/device/random.h"
#include "haptic_station/effects/effect_bank.h"
#include "tests/haptic_station/effects/level_skin.h"

namespace telepalp::effects {
namespace {

constexpr double kDt_s = 0.0005;

/// Input over the level skin y = 0; the device has moved from `before`.
EffectInput moved_to(const Eigen::Vector3d& device_m, const Eigen::Vector3d& before_m) {
  EffectInput in = over_level_skin(device_m);
  in.moved.v = device_m - before_m;
  return in;
}

Friction pressed_by_5_N() { return Friction({.coefficient = 0.4, .load = linear_law(500.0)}); }  // at 10 mm

TEST(Friction, UnderTheLimitAMinuteOfTremorDoesNotCreep) {
  Friction friction = pressed_by_5_N();
  const Eigen::Vector3d start{0.0, -0.01, 0.0};
  friction.begin(moved_to(start, start));
  device::Random random(3);
  Eigen::Vector3d before = start;
  for (int i = 0; i < 120000; ++i) {
    const Eigen::Vector3d now{0.001 + 0.0004 * random.uniform(-1.0, 1.0), -0.01, 0.0};
    const Force<HapticBase> force = friction.step(moved_to(now, before), kDt_s);
    ASSERT_NEAR(force.N.x(), -800.0 * now.x(), 1e-9);
    before = now;
  }
}

TEST(Friction, SlipsAtTheCoefficientTimesTheLoadAgainstTheWay) {
  Friction friction = pressed_by_5_N();
  Eigen::Vector3d at{0.0, -0.01, 0.0};
  Force<HapticBase> force;
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector3d next = at + Eigen::Vector3d{3e-5, 0.0, 4e-5};
    force = friction.step(moved_to(next, at), kDt_s);
    at = next;
  }
  EXPECT_NEAR((force.N - Eigen::Vector3d(-1.2, 0.0, -1.6)).norm(), 0.0, 1e-6);
}

TEST(Friction, IsZeroWithoutContact) {
  Friction friction = pressed_by_5_N();
  const Force<HapticBase> force = friction.step(moved_to({0.01, 0.001, 0.0}, {0.0, 0.001, 0.0}), kDt_s);
  EXPECT_EQ(force.N.norm(), 0.0);
}

TEST(Friction, NeverGivesOutMoreThanItTookOnARandomWay) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Friction friction = pressed_by_5_N();
    device::Random random(seed);
    Eigen::Vector3d at{0.0, -0.01, 0.0};
    Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
    double taken_J = 0.0;
    for (int i = 0; i < 20000; ++i) {
      const Eigen::Vector3d next{at.x() + 2e-5 * random.normal(), -0.02 * random.uniform(0.0, 1.0),
                                 at.z() + 2e-5 * random.normal()};
      const Eigen::Vector3d next_N = friction.step(moved_to(next, at), kDt_s).N;
      taken_J -= 0.5 * (force_N + next_N).dot(next - at);
      force_N = next_N;
      at = next;
      ASSERT_GE(taken_J - friction.stored_J(), -1e-9) << "seed " << seed << ", step " << i;
    }
  }
}

TEST(StiffRegions, AddTheirStiffnessWithinFadeOverTheRimAndAreNothingBeyond) {
  StiffRegions regions;
  ASSERT_TRUE(regions.add({.center = {}, .radius_m = 0.02, .fade_m = 0.02, .added_N_per_m = 300.0}));
  const auto up_N = [&](double x_m) {
    const Eigen::Vector3d at{x_m, -0.01, 0.0};
    return regions.step(moved_to(at, at), kDt_s).N.y();
  };
  EXPECT_NEAR(up_N(0.0), 3.0, 1e-12);
  EXPECT_NEAR(up_N(0.0199), 3.0, 1e-12);
  EXPECT_NEAR(up_N(0.03), 1.5, 1e-12);
  EXPECT_EQ(up_N(0.041), 0.0);
}

TEST(StiffRegions, ForceIsTheGradientOfTheEnergyWhereRegionsOverlap) {
  StiffRegions regions;
  ASSERT_TRUE(regions.add({.center = {{0.0, 0.0, 0.0}}, .radius_m = 0.01}));
  ASSERT_TRUE(regions.add({.center = {{0.02, 0.0, 0.01}}, .radius_m = 0.01, .fade_m = 0.015}));
  device::Random random(7);
  const auto energy_J = [&](const Eigen::Vector3d& at) {
    (void)regions.step(moved_to(at, at), kDt_s);
    return regions.energy_J();
  };
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d at{random.uniform(-0.05, 0.05), random.uniform(-0.03, -0.001), random.uniform(-0.05, 0.05)};
    const Eigen::Vector3d force_N = regions.step(moved_to(at, at), kDt_s).N;
    constexpr double h = 1e-7;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(axis);
      ASSERT_NEAR(force_N[axis], -(energy_J(at + step) - energy_J(at - step)) / (2.0 * h), 1e-4) << at.transpose();
    }
  }
}

TEST(StiffRegions, SayWhenTheyAreFull) {
  StiffRegions regions;
  for (std::size_t i = 0; i < StiffRegions::kMostRegions; ++i) EXPECT_TRUE(regions.add({}));
  EXPECT_FALSE(regions.add({}));
}

TEST(EffectBank, NamesFrictionAndRegionsOnTheBillWhenTheyAreAdded) {
  EffectBank bank;
  ASSERT_TRUE(bank.add(Friction{}));
  ASSERT_TRUE(bank.add(StiffRegions{}));
  (void)bank.step(moved_to({0.0, -0.01, 0.0}, {0.0, -0.01, 0.0}), kDt_s);
  EXPECT_STREQ(bank.bill()[0].name, "friction");
  EXPECT_STREQ(bank.bill()[1].name, "regions");
  EXPECT_EQ(bank.bill()[1].steps, 1U);
}

}  // namespace
}  // namespace telepalp::effects
