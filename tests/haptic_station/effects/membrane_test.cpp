#include "haptic_station/effects/membrane.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptic_station/device/random.h"
#include "haptic_station/effects/effect_bank.h"
#include "tests/haptic_station/effects/level_skin.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::effects {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

EffectInput tool_at(const Vector3d& device_m, const Quaterniond& attitude = Quaterniond::Identity()) {
  EffectInput in = over_level_skin(device_m);
  in.turn.attitude = attitude;
  return in;
}

MembraneSettings at_20_mm() { return {.at = {{0.0, -0.02, 0.0}}}; }

/// Moves straight down to the depth `deep_m` in steps of 0.01 mm.
template <class Visit>
void press(EffectBank& bank, double deep_m, const Visit& visit) {
  for (int i = 0; i <= static_cast<int>(std::lround(deep_m / 1e-5)); ++i)
    visit(bank.step(tool_at({0.0, -1e-5 * i, 0.0}), kTick_s).force.N, 1e-5 * i);
}

TEST(Membrane, PushesLikeASpringAndTearsAtItsForce) {
  EffectBank bank = bank_of({Membrane(at_20_mm())});
  double most_N = 0.0;
  press(bank, 0.02499, [&](const Vector3d& force_N, double deep_m) {
    ASSERT_NEAR(force_N.y(), 500.0 * std::max(0.0, deep_m - 0.02), 1e-9);
    most_N = std::max(most_N, force_N.norm());
  });
  EXPECT_NEAR(most_N, 2.495, 1e-9) << "paper S4 eq. (6): the threshold";
  EXPECT_EQ(bank.touch(), ObjectTouch::Upper);
  double last_N = most_N;
  for (int tick = 0; tick < 100; ++tick) {
    const double now_N = bank.step(tool_at({0.0, -0.0251, 0.0}), kTick_s).force.N.norm();
    EXPECT_LE(std::abs(now_N - last_N), 0.1) << "the force falls within 30 ms";
    last_N = now_N;
  }
  EXPECT_EQ(bank.touch(), ObjectTouch::None);
  EXPECT_LE(last_N, 0.3);
}

TEST(Membrane, TornItDragsWithItsFrictionAgainstTheMotionAndHoldsATipAtRest) {
  EffectBank bank = bank_of({Membrane(at_20_mm())});
  press(bank, 0.04, [](const Vector3d&, double) {});
  for (const Vector3d& towards : {Vector3d(-1.0, 0.0, 0.0), Vector3d(0.0, -1.0, 0.0), Vector3d(0.0, 0.6, 0.8)}) {
    Vector3d force_N;
    Vector3d here_m{0.0, -0.04, 0.0};
    for (int i = 0; i < 300; ++i) force_N = bank.step(tool_at(here_m += 1e-5 * towards), kTick_s).force.N;
    EXPECT_LT((force_N + 0.3 * towards).norm(), 0.01) << "S4 eq. (7): -C v / |v|";
    for (int i = 0; i < 1000; ++i)
      EXPECT_EQ(bank.step(tool_at(here_m), kTick_s).force.N, force_N) << "no chatter at rest";
    for (int i = 0; i < 300; ++i) force_N = bank.step(tool_at(here_m -= 1e-5 * towards), kTick_s).force.N;
  }
}

TEST(Membrane, HealsWithTheNextContactAndIsNotFeltFromBelow) {
  EffectBank bank = bank_of({Membrane(at_20_mm())});
  press(bank, 0.03, [](const Vector3d&, double) {});
  bank.begin(tool_at({0.0, -0.03, 0.0}));
  EXPECT_EQ(bank.step(tool_at({0.0, -0.03, 0.0}), kTick_s).force.N, Vector3d::Zero()) << "begins below the membrane";
  EXPECT_EQ(bank.step(tool_at({0.0, -0.01, 0.0}), kTick_s).force.N, Vector3d::Zero());
  EXPECT_NEAR(bank.step(tool_at({0.0, -0.022, 0.0}), kTick_s).force.N.y(), 1.0, 1e-9) << "whole again";
}

TEST(Membrane, GivesNoEnergyOnAnyPathWhetherTornOrNot) {
  constexpr std::uint64_t kSeed = 3;
  device::Random random(kSeed);
  EffectBank bank = bank_of({Skin{}, Membrane({.at = {{0.0, -0.02, 0.0}}, .skin_left = 0.5})});
  double given_J = 0.0;
  double worst_J = 0.0;
  Vector3d last_N = Vector3d::Zero();
  Vector3d here_m = Vector3d::Zero();
  for (int leg = 0; leg < 200; ++leg) {
    const double deep_m = leg < 100 ? 0.024 : 0.04;
    const Vector3d there_m{random.uniform(-0.01, 0.01), random.uniform(-deep_m, 0.0), random.uniform(-0.01, 0.01)};
    const int steps = 1 + static_cast<int>((there_m - here_m).norm() / 1e-5);
    const Vector3d hop_m = (there_m - here_m) / steps;
    for (int i = 0; i < steps; ++i) {
      const Vector3d force_N = bank.step(tool_at(here_m += hop_m), kTick_s, 10.0).force.N;
      given_J += 0.5 * (force_N + last_N).dot(hop_m);
      worst_J = std::max(worst_J, given_J + bank.energy_J());
      last_N = force_N;
    }
  }
  EXPECT_LE(worst_J, 1e-5) << "seed " << kSeed;
  EXPECT_EQ(bank.skin_left(), 0.5) << "it tore";
}

/// A needle of 0.1 m. The device gives 10 N and 0.2 N m.
TEST(Membrane, AtTheTipOfANeedleTheBoundedWrenchIsTheGradientOfOneEnergy) {
  constexpr std::uint64_t kSeed = 8;
  constexpr double kMost_N_m = 0.2;
  device::Random random(kSeed);
  const Membrane needle({.at = {}, .stiffness_N_per_m = 800.0, .tears_at_N = 1e9, .tip_m = kNeedle_m});
  int relaxed = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto tilt = [&] { return random.uniform(-1.2, 1.2); };
    const Quaterniond attitude = turned(Quaterniond::Identity(), {tilt(), tilt(), tilt()});
    const Vector3d device_m = Vector3d(0.01, -random.uniform(0.001, 0.04), -0.02) - attitude * kNeedle_m;
    const auto step = [&](const Vector3d& moved_m, const Vector3d& by_rad) {
      EffectBank bank;
      (void)bank.add(needle);
      EffectInput in = tool_at({0.0, 0.5, 0.0});
      in.turn.N_per_N_m = kMost_N / kMost_N_m;
      bank.begin(in);
      (void)bank.step(in, kTick_s, kMost_N);  // from above
      in = tool_at(device_m + moved_m, turned(attitude, by_rad));
      in.turn.N_per_N_m = kMost_N / kMost_N_m;
      const Wrench<HapticBase> wrench = bank.step(in, kTick_s, kMost_N);
      return std::tuple(wrench, bank.energy_J(), bank.relaxed_m());
    };
    const auto [wrench, energy_J, relaxed_m] = step(Vector3d::Zero(), Vector3d::Zero());
    relaxed += relaxed_m > 0.0 ? 1 : 0;
    ASSERT_LE(wrench.force.N.norm(), kMost_N + 1e-9);
    ASSERT_LE(wrench.torque.N_m.norm(), kMost_N_m + 1e-9) << "seed " << kSeed;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d hop = 1e-6 * Vector3d::Unit(axis);
      const double by_m = (std::get<1>(step(hop, {0, 0, 0})) - std::get<1>(step(-hop, {0, 0, 0}))) / 2e-6;
      const double by_rad = (std::get<1>(step({0, 0, 0}, hop)) - std::get<1>(step({0, 0, 0}, -hop))) / 2e-6;
      ASSERT_NEAR(wrench.force.N[axis], -by_m, 0.01) << "seed " << kSeed;
      ASSERT_NEAR(wrench.torque.N_m[axis], -by_rad, 0.001) << "seed " << kSeed;
    }
  }
  EXPECT_GT(relaxed, 500);
}

TEST(Membrane, TwoThatWeakenTheSkinMultiplyAndTheSkinOnlyGetsWeakerInAContact) {
  const auto weakens = [](double y_m) {
    return Membrane({.at = {{0.0, y_m, 0.0}}, .tears_at_N = 1.0, .friction_N = 0.0, .skin_left = 0.5});
  };
  EffectBank bank = bank_of({Skin({.law = linear_law(100.0)}), weakens(-0.01), weakens(-0.02)});
  double last = 1.0;
  const auto watch = [&](const Vector3d&, double) {
    ASSERT_LE(bank.skin_left(), last);
    last = bank.skin_left();
  };
  press(bank, 0.016, watch);
  EXPECT_EQ(last, 0.5) << "the upper one is torn";
  press(bank, 0.03, watch);
  EXPECT_EQ(last, 0.25);
  EXPECT_NEAR(bank.step(tool_at({0.0, -0.03, 0.0}), kTick_s).force.N.y(), 0.25 * 100.0 * 0.03, 1e-9);
  bank.begin(tool_at({0.0, 0.0, 0.0}));
  EXPECT_EQ(bank.skin_left(), 1.0) << "the next contact";
  EXPECT_NEAR(bank.step(tool_at({0.0, -0.005, 0.0}), kTick_s).force.N.y(), 0.5, 1e-9);
}

}  // namespace
}  // namespace telepalp::effects
