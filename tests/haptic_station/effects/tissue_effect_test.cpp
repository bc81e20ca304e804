#include <gtest/gtest.h>

#include <cmath>

#include "haptic_station/effects/effect_bank.h"
#include "tests/haptic_station/effects/level_skin.h"
#include "tests/haptic_station/tissue/needle_paths.h"

namespace telepalp::effects {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

EffectInput needle_at(const Vector3d& device_m, const Quaterniond& attitude = Quaterniond::Identity()) {
  EffectInput in = over_level_skin(device_m);
  in.turn.attitude = attitude;
  in.turn.N_per_N_m = kMost_N / 0.2;
  return in;
}

LayeredTissueSettings needle(const Vector3d& tip_m = Vector3d::Zero(), double skin_left = 1.0) {
  return {.model = *tissue::make_tissue(tissue::three_layers()), .tip_m = tip_m, .skin_left = skin_left};
}

/// Moves straight from `from_m` to `to_m` at 20 mm/s.
template <class Visit>
void go(const Vector3d& from_m, const Vector3d& to_m, const Visit& visit) {
  const int steps = static_cast<int>(std::ceil((to_m - from_m).norm() / 1e-5));
  for (int i = 1; i <= steps; ++i) visit(Vector3d(from_m + (to_m - from_m) * i / steps));
}

TEST(LayeredTissueEffect, HasTheTissuesWrenchWithTheLeverToTheTip) {
  const LayeredTissueSettings settings = needle(kNeedle_m);
  LayeredTissue effect(settings);
  tissue::LayeredTissue alone(settings.model);
  const Quaterniond tilted(Eigen::AngleAxisd(0.3, Vector3d::UnitZ()));
  const Vector3d lever_m = tilted * kNeedle_m;
  const auto tip = [&](double deep_m) { return Vector3d(0.003, -deep_m, 0.0); };
  effect.begin(needle_at(tip(0.0) - lever_m, tilted));
  alone.begin({.tip_m = tip(0.0), .axis = lever_m.normalized()});
  double most_N_m = 0.0;
  double shaft_N_m = 0.0;
  for (int i = 1; i <= 4000; ++i) {
    const Wrench<HapticBase> got = effect.step(needle_at(tip(1e-5 * i) - lever_m, tilted), kTick_s);
    const tissue::TissueWrench own = alone.step(
        {.tip_m = tip(1e-5 * i), .axis = lever_m.normalized(), .bevel = tilted * Vector3d::UnitX()}, kTick_s);
    ASSERT_LT((got.force.N - own.force_N).norm(), 1e-9);
    ASSERT_LT((got.torque.N_m - own.torque_N_m - lever_m.cross(own.force_N)).norm(), 1e-9);
    most_N_m = std::max(most_N_m, got.torque.N_m.norm());
    shaft_N_m = std::max(shaft_N_m, own.torque_N_m.norm());
  }
  EXPECT_GT(most_N_m, 0.02) << "the doctor feels the lever";
  EXPECT_GT(shaft_N_m, 1e-3) << "and the shaft in the hole of the skin";
}

/// Bounds as of a device that warms up and cools down; the tissue alone asks for up to 5 N.
TEST(LayeredTissueEffect, GivesNoEnergyAndStaysWithinTheDevicesForceAndTorqueOnAnyPath) {
  for (const std::uint64_t seed : {4, 5}) {
    device::Random random(seed);
    EffectBank bank;
    (void)bank.add(Skin({.law = linear_law(100.0)}));
    (void)bank.add(LayeredTissue(needle(kNeedle_m, 0.3)));
    const Vector3d over_m = -kNeedle_m;
    bank.begin(needle_at(over_m));
    double given_J = 0.0;
    double worst_J = 0.0;
    double most_N = 0.0;
    Wrench<HapticBase> last;
    Vector3d here_m = over_m;
    Vector3d turn = Vector3d::Zero();
    for (int leg = 0; leg < 150; ++leg) {
      const double bound_N = random.uniform(1.0, kMost_N);
      const auto draw = [&](double most) { return random.uniform(-most, most); };
      const Vector3d there_m = over_m + Vector3d(draw(0.01), random.uniform(-0.05, 0.003), draw(0.01));
      const Vector3d turn_to(draw(0.2), draw(0.2), draw(0.2));
      const int steps = 1 + static_cast<int>((there_m - here_m).norm() / 2e-5);
      const Vector3d hop_m = (there_m - here_m) / steps;
      const Vector3d start = turn;
      for (int i = 1; i <= steps; ++i) {
        const Quaterniond before = turned(Quaterniond::Identity(), turn);
        turn = start + (turn_to - start) * i / steps;
        const Quaterniond now = turned(Quaterniond::Identity(), turn);
        const Eigen::AngleAxisd by(now * before.inverse());
        const Wrench<HapticBase> wrench = bank.step(needle_at(here_m += hop_m, now), kTick_s, bound_N);
        ASSERT_LE(wrench.force.N.norm(), bound_N + 1e-9) << "seed " << seed;
        ASSERT_LE(wrench.torque.N_m.norm(), bound_N * 0.2 / kMost_N + 1e-9) << "seed " << seed;
        given_J += 0.5 * (wrench.force.N + last.force.N).dot(hop_m);
        given_J += 0.5 * (wrench.torque.N_m + last.torque.N_m).dot(by.angle() * by.axis());
        worst_J = std::max(worst_J, given_J + bank.energy_J());
        most_N = std::max(most_N, wrench.force.N.norm());
        last = wrench;
      }
    }
    EXPECT_LE(worst_J, 1e-4) << "seed " << seed;
    EXPECT_LT(given_J, -0.02) << "the path goes through the tissue";
    EXPECT_GT(most_N, 2.0) << "seed " << seed;
  }
}

TEST(LayeredTissueEffect, AHoleLastsWeakensTheSkinAboveItAloneAndIsNotPuncturedAgain) {
  EffectBank bank;
  (void)bank.add(LayeredTissue(needle(Vector3d::Zero(), 0.4)));
  const auto goes_in_at = [&](double x_m) {
    double most_N = 0.0;
    bank.begin(needle_at({x_m, 0.001, 0.0}));
    go({x_m, 0.001, 0.0}, {x_m, -0.02, 0.0}, [&](const Vector3d& device_m) {
      most_N = std::max(most_N, bank.step(needle_at(device_m), kTick_s, kMost_N).force.N.norm());
    });
    return most_N;
  };
  EXPECT_GT(goes_in_at(0.0), 2.4) << "the puncture";
  EXPECT_NEAR(bank.skin_left(), 0.4, 1e-9);
  EXPECT_LT(goes_in_at(0.0), 1.5) << "the hole";
  EXPECT_NEAR(bank.skin_left(), 0.4, 1e-9);
  bank.begin(needle_at({0.02, 0.001, 0.0}));
  (void)bank.step(needle_at({0.02, -0.003, 0.0}), kTick_s, kMost_N);
  EXPECT_EQ(bank.skin_left(), 1.0) << "20 mm beside the hole";
  EXPECT_EQ(bank.touch(), ObjectTouch::Upper);
}

TEST(LayeredTissueEffect, ATurnThatWouldPressTheTipInIsJudgedWithoutAChangeOfState) {
  LayeredTissue effect(needle({0.02, 0.0, 0.0}));
  effect.begin(needle_at({0.0, 0.0, 0.0}));
  (void)effect.step(needle_at({0.0, -0.002, 0.0}), kTick_s);
  const double stored_J = effect.stored_J();
  const EffectInput same = needle_at({0.0, -0.002, 0.0});
  const EffectInput down = needle_at({0.0, -0.002, 0.0}, Quaterniond(Eigen::AngleAxisd(-0.05, Vector3d::UnitZ())));
  const EffectInput through = needle_at({0.0, -0.002, 0.0}, Quaterniond(Eigen::AngleAxisd(-0.5, Vector3d::UnitZ())));
  EXPECT_NEAR(effect.loaded_J(same), stored_J, 1e-12);
  EXPECT_GT(effect.loaded_J(down), 1.5 * stored_J);
  EXPECT_GT(effect.loaded_J(through), effect.loaded_J(down)) << "a turn that punctures is no way down";
  EXPECT_EQ(effect.stored_J(), stored_J);
}

TEST(LayeredTissueEffect, WithoutTissueIsNotFelt) {
  LayeredTissue effect;
  effect.begin(needle_at({0.0, 0.0, 0.0}));
  EXPECT_EQ(effect.step(needle_at({0.0, -0.01, 0.0}), kTick_s).force.N, Vector3d::Zero());
  EXPECT_EQ(effect.holds_N() + effect.stored_J() + effect.stiffest_N_per_m(1.0), 0.0);
  EXPECT_EQ(effect.skin_left(), 1.0);
}

}  // namespace
}  // namespace telepalp::effects
