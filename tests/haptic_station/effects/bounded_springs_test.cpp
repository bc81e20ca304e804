// The force of a scene whose springs ask for more than the device gives.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "haptic_station/device/random.h"
#include "haptic_station/effects/effect_bank.h"
#include "tests/haptic_station/effects/level_skin.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::effects {
namespace {

using Eigen::Vector3d;

EffectInput over_skin(const Vector3d& device_m, const Vector3d& moved_m = Vector3d::Zero()) {
  EffectInput in = over_level_skin(device_m);
  in.moved.v = moved_m;
  return in;
}

InnerCylinder palpated_cylinder() { return InnerCylinder({.top_center = {{0.0, -0.03, 0.0}}}); }

StiffRegions two_regions() {
  StiffRegions regions;
  (void)regions.add({.center = {{0.01, 0.0, 0.0}}, .radius_m = 0.01, .fade_m = 0.04, .added_N_per_m = 200.0});
  (void)regions.add({.center = {{-0.02, 0.0, 0.01}}, .radius_m = 0.01, .fade_m = 0.04, .added_N_per_m = 100.0});
  return regions;
}

TEST(CommonRelaxation, RelaxesLinearSpringsUntilTheirForcesSumToTheBound) {
  const LinearSpring deep{.stiffness_N_per_m = 800.0, .depth_m = 0.02, .outwards = Vector3d::UnitX()};
  const LinearSpring shallow{.stiffness_N_per_m = 200.0, .depth_m = 0.01, .outwards = Vector3d::UnitY()};
  const auto pull_at = [&](double relaxed_m) {
    Pull sum = deep.pull(relaxed_m);
    return sum += shallow.pull(relaxed_m);
  };
  EXPECT_NEAR(common_relaxation_m(pull_at, 10.0), 0.008, 1e-12) << "9.6 N and 0.4 N";
  EXPECT_NEAR(common_relaxation_m(pull_at, 4.0), 0.015, 1e-12) << "the shallow spring is slack";
  EXPECT_EQ(common_relaxation_m(pull_at, 18.0), 0.0);
  EXPECT_NEAR(common_relaxation_m(pull_at, 0.0), 0.02, 1e-9) << "a device without force";
}

TEST(CommonRelaxation, ReachesTheBoundWithAnyLawOfTheSkin) {
  for (const SkinLaw& law : {SkinLaw{}, linear_law(900.0), SkinLaw{.by_axis = true},
                             SkinLaw{.constant_N_per_m = 0.0, .slope_N_per_m2 = 0.0, .curve_N_per_m3 = 1e6}})
    for (const double most_N : {0.01, 4.0, 10.0}) {
      const Vector3d d_m{0.05, -0.12, 0.01};
      const double relaxed_m =
          common_relaxation_m([&](double relaxed) { return skin_pull(law, d_m, relaxed); }, most_N);
      EXPECT_NEAR(skin_pull(law, d_m, relaxed_m).N, most_N, 1e-6);
      EXPECT_LE(skin_force_N(law, d_m, relaxed_m).norm(), most_N + 1e-6);
    }
}

TEST(EffectBank, OneSpringKeepsItsDirectionAtTheBound) {
  EffectBank bank = bank_of({Skin({.law = linear_law(500.0)})});
  const Vector3d asked_N = bank.step(over_skin({0.03, -0.04, 0.0}), kTick_s).force.N;
  const Vector3d given_N = bank.step(over_skin({0.03, -0.04, 0.0}), kTick_s, kMost_N).force.N;
  EXPECT_NEAR((given_N - asked_N * (kMost_N / asked_N.norm())).norm(), 0.0, 1e-9);
  EXPECT_NEAR(bank.relaxed_m(), 0.03, 1e-9) << "25 N at 50 mm, 10 N at 20 mm";
}

TEST(EffectBank, BelowTheBoundNothingIsRelaxed) {
  EffectBank bank = bank_of({Skin{}, palpated_cylinder()});
  const EffectInput in = over_skin({0.005, -0.034, 0.0});
  const Vector3d asked_N = bank.step(in, kTick_s).force.N;
  EXPECT_EQ(bank.step(in, kTick_s, kMost_N).force.N, asked_N);
  EXPECT_EQ(bank.relaxed_m(), 0.0);
}

/// Goes along `way`, corner by corner, in steps of 0.01 mm.
template <class Visit>
void go(const std::vector<Vector3d>& way, const Visit& visit) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const int steps = static_cast<int>(std::ceil((way[i] - way[i - 1]).norm() / 1e-5));
    const Vector3d hop_m = (way[i] - way[i - 1]) / steps;
    for (int k = 1; k <= steps; ++k) visit(Vector3d(way[i - 1] + k * hop_m), hop_m);
  }
}

/// In over the cylinder's top, out over its rim. Skin and cylinder ask for up to 19 N.
TEST(EffectBank, AHandThatEntersOverTheTopAndLeavesOverTheRimGetsNoEnergy) {
  for (const double beside_m : {0.0, 0.008})
    for (const double deep_m : {0.045, 0.055, 0.065}) {
      EffectBank bank = bank_of({Skin{}, palpated_cylinder()});
      const std::vector<Vector3d> lap{{0.005, 0.0, beside_m},
                                      {0.005, -deep_m, beside_m},
                                      {0.045, -deep_m, beside_m},
                                      {0.045, 0.0, beside_m},
                                      {0.005, 0.0, beside_m}};
      bank.begin(over_skin(lap.front()));
      double gained_J = 0.0;
      double step_N = 0.0;
      Vector3d last_N = Vector3d::Zero();
      go(lap, [&](const Vector3d& device_m, const Vector3d& hop_m) {
        const Vector3d force_N = bank.step(over_skin(device_m, hop_m), kTick_s, kMost_N).force.N;
        ASSERT_LE(force_N.norm(), kMost_N + 1e-6);
        gained_J += 0.5 * (force_N + last_N).dot(hop_m);
        step_N = std::max(step_N, (force_N - last_N).norm());
        last_N = force_N;
      });
      EXPECT_NEAR(gained_J, 0.0, 1e-4) << "deep: " << deep_m << ", beside: " << beside_m;
      EXPECT_LE(step_N, 0.03) << "over 0.01 mm";
    }
}

TEST(EffectBank, TheBoundedForceIsTheGradientOfItsEnergy) {
  constexpr std::uint64_t kSeed = 11;
  device::Random random(kSeed);
  EffectBank banks[] = {bank_of({Skin{}, palpated_cylinder(), InnerSphere({.center = {{0.03, -0.05, 0.0}}})}),
                        bank_of({Skin({.law = SkinLaw{.by_axis = true}}), palpated_cylinder()}),
                        bank_of({Skin({.law = {}, .anchor = SkinAnchor::Sliding}), two_regions()})};
  int relaxed = 0;
  for (EffectBank& bank : banks)
    for (int i = 0; i < 3000; ++i) {
      const Vector3d p{random.uniform(-0.05, 0.05), random.uniform(-0.09, -0.02), random.uniform(-0.05, 0.05)};
      const double most_N = random.uniform(2.0, 12.0);
      const auto energy_J = [&](const Vector3d& device_m) {
        (void)bank.step(over_skin(device_m), kTick_s, most_N);
        return bank.energy_J();
      };
      bank.begin(over_skin({0.0, 0.0, 0.0}));
      const Vector3d force_N = bank.step(over_skin(p), kTick_s, most_N).force.N;
      relaxed += bank.relaxed_m() > 0.0 ? 1 : 0;
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3d step_m = 1e-6 * Vector3d::Unit(axis);
        const double slope = (energy_J(p + step_m) - energy_J(p - step_m)) / 2e-6;
        ASSERT_NEAR(force_N[axis], -slope, 0.02) << p.transpose() << ", seed " << kSeed;
      }
    }
  EXPECT_GT(relaxed, 3000);
}

TEST(EffectBank, NoPathGivesEnergyAtABoundThatFalls) {
  constexpr std::uint64_t kSeed = 5;
  device::Random random(kSeed);
  EffectBank bank = bank_of({Skin{}, palpated_cylinder(), InnerSphere({.center = {{0.03, -0.05, 0.0}}})});
  double given_J = 0.0;
  double worst_J = 0.0;
  double most_N = 12.0;
  Vector3d last_N = Vector3d::Zero();
  Vector3d here{0.0, 0.0, 0.0};
  for (int leg = 0; leg < 100; ++leg) {
    const Vector3d there{random.uniform(-0.05, 0.05), random.uniform(-0.09, 0.0), random.uniform(-0.05, 0.05)};
    go({here, there}, [&](const Vector3d& device_m, const Vector3d& hop_m) {
      most_N = std::max(4.0, most_N - 1e-5);
      const Vector3d force_N = bank.step(over_skin(device_m, hop_m), kTick_s, most_N).force.N;
      given_J += 0.5 * (force_N + last_N).dot(hop_m);
      worst_J = std::max(worst_J, given_J + bank.energy_J());
      last_N = force_N;
    });
    here = there;
  }
  EXPECT_LE(worst_J, 1e-3) << "seed " << kSeed;
}

TEST(EffectBank, AHigherBoundStoresMoreEnergy) {
  EffectBank bank = bank_of({Skin{}, palpated_cylinder()});
  double last_J = 0.0;
  for (const double most_N : {1.0, 4.0, 10.0, 1000.0}) {
    (void)bank.step(over_skin({0.005, -0.055, 0.0}), kTick_s, most_N);
    EXPECT_GT(bank.energy_J(), last_J) << most_N;
    last_J = bank.energy_J();
  }
}

/// The skin slides, so that friction acts across its force.
TEST(EffectBank, FrictionFollowsTheDisplayedSkinAndStaysWithinTheBound) {
  EffectBank bank = bank_of({Skin({.law = linear_law(500.0), .anchor = SkinAnchor::Sliding}),
                             Friction({.coefficient = 0.4, .load = linear_law(500.0)})});
  Vector3d force_N = Vector3d::Zero();
  double taken_J = 0.0;
  double least_J = 0.0;
  go({{0.0, 0.0, 0.0}, {0.0, -0.04, 0.0}, {0.02, -0.04, 0.0}, {-0.01, -0.03, 0.02}, {0.03, -0.05, 0.0}},
     [&](const Vector3d& device_m, const Vector3d& hop_m) {
       force_N = bank.step(over_skin(device_m, hop_m), kTick_s, kMost_N).force.N;
       taken_J += bank.absorbed_J();
       least_J = std::min(least_J, taken_J - bank.energy_J());
       ASSERT_LE(force_N.norm(), kMost_N + 1e-6);
     });
  EXPECT_NEAR(force_N.norm(), kMost_N, 1e-3) << "all of the bound is used while the hand slips";
  EXPECT_NEAR(std::hypot(force_N.x(), force_N.z()) / force_N.y(), 0.4, 1e-3);
  EXPECT_GE(least_J, -1e-3);
}

TEST(EffectBank, TellsWhatAnotherHeightOfTheSkinWouldChange) {
  const auto law = linear_law(400.0);
  for (const double most_N : {1000.0, 10.0}) {
    EffectBank bank = bank_of({Skin({.law = law, .anchor = SkinAnchor::Sliding}), palpated_cylinder()});
    EffectBank higher = bank;
    const EffectInput in = over_skin({0.02, -0.045, 0.0});
    EffectInput risen = in;
    risen.contact.proxy.m.y() += 0.006;
    const Vector3d change_N = higher.step(risen, kTick_s, most_N).force.N - bank.step(in, kTick_s, most_N).force.N;
    EXPECT_NEAR((bank.change_with_skin_at({0.0, -0.051, 0.0}).N - change_N).norm(), 0.0, 1e-8) << most_N;
    EXPECT_NEAR(bank.change_with_skin_at(bank.indentation().v).N.norm(), 0.0, 1e-8);
  }
  EXPECT_EQ(bank_of({palpated_cylinder()}).change_with_skin_at({0.0, -0.01, 0.0}).N, Vector3d::Zero());
}

}  // namespace
}  // namespace telepalp::effects
