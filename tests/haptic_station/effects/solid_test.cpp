#include "haptic_station/effects/solid.h"

#include <gtest/gtest.h>

#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/solids/polish.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::effects {
namespace {

using Eigen::Vector3d;

Solid layer(const std::string& polish, double stiffness_N_per_m, double pulse_m = 0.0) {
  const auto tree = *solids::build_tree(*solids::parse_polish(polish, "test"));
  return Solid({.layer = std::make_shared<const SolidLayer>(SolidLayer{"layer", tree, {}}),
                .stiffness_N_per_m = stiffness_N_per_m,
                .pulse_m = pulse_m});
}

EffectInput pressed_at(const Vector3d& device) {
  EffectInput in;
  in.device.m = device;
  in.contact.normal.v = Vector3d::UnitY();
  in.contact.distance_m = device.y();
  return in;
}

TEST(Solid, EachLayerPushesWithItsOwnStiffness) {
  EffectBank bank;
  ASSERT_TRUE(bank.add(layer("tr 0 -0.03 0 sphere 0.02", 300.0)));  // top at -0.01
  ASSERT_TRUE(bank.add(layer("tr 0 -0.03 0 sphere 0.01", 900.0)));  // top at -0.02
  bank.begin(pressed_at({0.0, 0.0, 0.0}));
  Force<HapticBase> force;
  for (int i = 0; i <= 500; ++i) force = bank.step(pressed_at({0.0, -5e-5 * i, 0.0}), kTick_s).force;
  EXPECT_NEAR(force.N.y(), 300.0 * 0.015 + 900.0 * 0.005, 1e-2);
  EXPECT_EQ(bank.touch(), ObjectTouch::Upper);
  EXPECT_NEAR(bank.energy_J(), 0.5 * 300.0 * 0.015 * 0.015 + 0.5 * 900.0 * 0.005 * 0.005, 1e-4);
}

/// A finger slides across a rib of 8 mm radius, 5 mm deep in it.
struct Slide {
  double most_N = 0.0;
  double worst_step_N = 0.0;
};
Slide across_a_rib(double tip_radius_m) {
  const auto tree = *solids::build_tree(*solids::parse_polish("capsule -0.1 -0.02 0 0.1 -0.02 0 0.008", "test"));
  Solid rib({.layer = std::make_shared<const SolidLayer>(SolidLayer{"rib", tree, {}}),
             .stiffness_N_per_m = 1000.0,
             .tip_radius_m = tip_radius_m});
  Slide slide;
  Vector3d last_N = Vector3d::Zero();
  rib.begin(pressed_at({0.0, 0.0, -0.03}));
  for (int i = 0; i < 6000; ++i) {
    const Vector3d now_N = rib.step(pressed_at({0.0, -0.017, -0.03 + 1e-5 * i}), kTick_s).N;
    slide.most_N = std::max(slide.most_N, now_N.norm());
    slide.worst_step_N = std::max(slide.worst_step_N, (now_N - last_N).norm());
    last_N = now_N;
  }
  return slide;
}

TEST(Solid, ARoundFingertipFeelsTheTopAtTheSameDepthAndTheSidesLessSteeply) {
  const Slide point = across_a_rib(0.0);
  const Slide finger = across_a_rib(0.006);
  EXPECT_NEAR(point.most_N, 1000.0 * 0.005, 0.02);
  EXPECT_NEAR(finger.most_N, 1000.0 * 0.005, 0.02);
  EXPECT_NEAR(point.worst_step_N, 1000.0 * 1e-5 * 5.0 / 3.0, 1e-3) << "k d / (r - d) for each metre of the slide";
  EXPECT_LE(finger.worst_step_N, 1000.0 * 1e-5 * 1.01) << "no more than the spring's own stiffness";
}

TEST(Solid, MovesWithTheBody) {
  EffectBank bank;
  ASSERT_TRUE(bank.add(layer("tr 0 -0.03 0 sphere 0.02", 500.0)));
  ASSERT_TRUE(bank.object_at(0).has_value());
  EXPECT_NEAR(bank.object_at(0)->m.y(), -0.03, 1e-12);
  Placements moved{};
  moved[0].moved.v = {0.0, 0.004, 0.0};
  bank.place(moved);
  bank.begin(pressed_at({0.0, 0.0, 0.0}));
  Force<HapticBase> force;
  for (int i = 0; i <= 200; ++i) force = bank.step(pressed_at({0.0, -5e-5 * i, 0.0}), kTick_s).force;
  EXPECT_NEAR(force.N.y(), 500.0 * 0.004, 1e-2) << "the top has risen from -0.01 to -0.006";
}

TEST(Solid, APulseBeatsAgainstAHandAtRestAndBooksItsWork) {
  EffectBank bank;
  ASSERT_TRUE(bank.add(layer("capsule 0 -0.03 -0.1 0 -0.03 0.1 0.01", 400.0, 0.002)));
  bank.begin(pressed_at({0.0, 0.0, 0.0}));
  for (int i = 0; i <= 500; ++i) (void)bank.step(pressed_at({0.0, -5e-5 * i, 0.0}), kTick_s);
  double least_N = HUGE_VAL;
  double most_N = 0.0;
  double taken_J = 0.0;
  const double before_J = bank.energy_J();
  EffectInput rests = pressed_at({0.0, -0.025, 0.0});
  for (int i = 0; i < 4000; ++i) {
    const double force_N = bank.step(rests, kTick_s).force.N.y();
    least_N = std::min(least_N, force_N);
    most_N = std::max(most_N, force_N);
    taken_J += bank.absorbed_J();
  }
  EXPECT_NEAR(most_N - least_N, 400.0 * 0.002, 0.01);
  EXPECT_NEAR(bank.energy_J() - before_J, taken_J, 1e-5) << "the wall's work is what the spring stores";
}

TEST(Solid, AFingerAcrossRibsFeelsEachOfThem) {
  std::string ribs;
  for (int i = 0; i < 6; ++i)
    ribs += std::string(i < 5 ? "+ " : "") + "tr 0 -0.162 " + std::to_string(0.03 * i) + " torusz 0.14 0.008 ";
  EffectBank bank;
  ASSERT_TRUE(bank.add(layer(ribs, 1200.0)));
  bank.begin(pressed_at({0.0, 0.0, -0.02}));
  double last_N = 0.0;
  double largest_step_N = 0.0;
  int peaks = 0;
  bool high = false;
  for (int i = 0; i < 8000; ++i) {
    const double force_N = bank.step(pressed_at({0.0, -0.018, -0.02 + 2.5e-5 * i}), kTick_s).force.N.norm();
    largest_step_N = std::max(largest_step_N, std::abs(force_N - last_N));
    last_N = force_N;
    if (!high && force_N > 3.0) ++peaks;
    high = high ? force_N > 1.0 : force_N > 3.0;
  }
  EXPECT_EQ(peaks, 6);
  EXPECT_LE(largest_step_N, 0.05);
}

}  // namespace
}  // namespace telepalp::effects
