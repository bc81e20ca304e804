#include "haptic_station/tracking/hover/guided_hand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace telepalp::tracking {
namespace {

constexpr double kStep_s = 0.01;

/// Level skin at y = 0, and from x = 0.1 m on a step of 0.2 m, as from a bed to a trunk.
SkinHeights step_at_100_mm() {
  SkinHeights skin;
  for (double x = -0.5; x < 0.5; x += 0.005)
    for (double z = -0.5; z < 0.5; z += 0.005) skin.add({{x, x < 0.1 ? 0.0 : 0.2, z}});
  return skin;
}

const Point<HapticBase> kDevice{{0.0, 0.03, 0.0}};

TEST(GuidedHand, IsNeverFasterThanAHandWhateverThePointerDoes) {
  const SkinHeights skin = step_at_100_mm();
  constexpr unsigned kSeed = 20261126;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> place(-0.3, 0.3);
  GuidedHand hand;
  Point<HapticBase> before = kDevice;
  for (int i = 0; i < 20'000; ++i) {
    const GuidedHand::Wanted wanted{{{place(random), place(random), place(random)}}, random() % 2 == 0};
    const GuidedHand::Guided guided = hand.follow(wanted, {{place(random), 0.25, place(random)}}, skin, kStep_s);
    const double way_m = i == 0 ? 0.0 : (guided.hand.m - before.m).norm();  // the first one is the device's place
    EXPECT_LE(way_m, GuidedHand::kFastest_m_per_s * kStep_s + 1e-12);
    before = guided.hand;
  }
}

TEST(GuidedHand, BeginsAtTheDeviceAndStandsStillWithoutTime) {
  GuidedHand hand;
  EXPECT_EQ(hand.follow({{{0.3, 0.05, 0.0}}, true}, kDevice, {}, 0.0).hand.m, kDevice.m);
  EXPECT_EQ(hand.follow({{{0.3, 0.05, 0.0}}, true}, kDevice, {}, -5.0).hand.m, kDevice.m);
  const Point<HapticBase> after_a_pause = hand.follow({{{0.3, 0.05, 0.0}}, true}, kDevice, {}, 60.0).hand;
  EXPECT_LE((after_a_pause.m - kDevice.m).norm(), 0.05) << "it does not jump";
}

TEST(GuidedHand, WaitsBeforeAStepUntilTheDeviceIsAboveIt) {
  const SkinHeights skin = step_at_100_mm();
  GuidedHand hand;
  const GuidedHand::Wanted over_the_step{{{0.3, 0.25, 0.0}}, true};
  Point<HapticBase> device = kDevice;
  GuidedHand::Guided guided;
  const auto fly = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      guided = hand.follow(over_the_step, device, skin, kStep_s);
      device.m.x() = guided.hand.m.x();
    }
  };
  fly(300);
  EXPECT_LT(guided.hand.m.x(), 0.06) << "it waits before the step";
  ASSERT_TRUE(guided.wait_at_m);
  EXPECT_NEAR(*guided.wait_at_m, 0.22, 1e-6) << "the device must rise above the step";
  EXPECT_GT(guided.hand.m.y(), 0.25) << "the hand itself is already high";
  device.m.y() = 0.22;
  fly(300);
  EXPECT_NEAR(guided.hand.m.x(), 0.3, 1e-3);
}

TEST(GuidedHand, WaitsForADeviceThatLagsBehind) {
  GuidedHand hand;
  GuidedHand::Guided guided;
  for (int i = 0; i < 300; ++i) guided = hand.follow({{{0.3, 0.05, 0.0}}, true}, kDevice, {}, kStep_s);
  EXPECT_LE(guided.hand.m.x(), 0.061) << "the device has not moved";
}

TEST(GuidedHand, PressesOnlyWhereItHasArrivedAndComesDownSlowly) {
  const SkinHeights skin = step_at_100_mm();
  GuidedHand hand;
  Point<HapticBase> device{{0.0, 0.06, 0.0}};
  const Point<HapticBase> pressed{{-0.3, -0.04, 0.0}};
  (void)hand.follow({{{-0.3, 0.05, 0.0}}, true}, device, skin, kStep_s);
  Point<HapticBase> before = device;
  for (int i = 0; i < 400; ++i) {
    const Point<HapticBase> at = hand.follow({pressed, false}, device, skin, kStep_s).hand;
    const bool is_on_the_way = i > 20;  // the first steps rise from the device
    const bool comes_down = at.m.y() < 0.05;
    if (is_on_the_way && comes_down) {
      EXPECT_NEAR(at.m.x(), pressed.m.x(), 0.016) << "it flies to the place first";
    }
    if (is_on_the_way && before.m.y() < 0.06) {
      EXPECT_GE(at.m.y() - before.m.y(), -0.0012 - 1e-12) << "it comes down at 0.12 m/s";
    }
    device.m.x() = at.m.x();
    before = at;
  }
  EXPECT_NEAR(before.m.y(), pressed.m.y(), 1e-3);
  for (int i = 0; i < 100; ++i) before = hand.follow({{{-0.2, -0.04, 0.0}}, false}, device, skin, kStep_s).hand;
  EXPECT_NEAR(before.m.x(), -0.2, 1e-3) << "in contact it follows the pointer straight";
  EXPECT_NEAR(before.m.y(), -0.04, 1e-3);
}

TEST(GuidedHand, TheNoiseOfTheSkinUnderARestingPointerHardlyMovesTheHand) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.002);
  GuidedHand hand;
  double least_m = 1.0, most_m = -1.0;
  for (int i = 0; i < 1000; ++i) {
    const double x_m = hand.follow({{{noise(random), 0.06, noise(random)}}, true}, kDevice, {}, kStep_s).hand.m.x();
    if (i < 300) continue;
    least_m = std::min(least_m, x_m);
    most_m = std::max(most_m, x_m);
  }
  EXPECT_LT(most_m - least_m, 0.003) << "of 12 mm";
}

TEST(GuidedHand, AHandThatIsTrackedIsFollowedStraightIntoTheSkin) {
  const SkinHeights skin = step_at_100_mm();
  GuidedHand hand;
  GuidedHand::Guided guided;
  for (int i = 0; i < 100; ++i) guided = hand.follow({{{0.2, 0.1, 0.0}}, false}, kDevice, skin, kStep_s);
  EXPECT_NEAR(guided.hand.m.x(), 0.2, 1e-9);
  EXPECT_FALSE(guided.wait_at_m) << "and the device waits on the scene's plane";
}

TEST(SkinHeights, AreThoseOfTheImageWithoutASingleWrongPixel) {
  DepthImage depth{.width = 640, .height = 480, .unit_m = 0.001, .samples = {}};
  depth.samples.assign(640 * 480, 800);
  depth.samples[240 * 640 + 320] = 300;  // one pixel, half a metre too near
  for (int row = 0; row < 480; ++row) std::fill_n(&depth.samples[row * 640], 100, 0);  // the left is not measured
  for (int row = 200; row < 280; ++row) std::fill_n(&depth.samples[row * 640 + 400], 80, 700);
  const Intrinsics camera{640, 480, 525.0, 525.0, 319.5, 239.5};
  Transform<HapticBase, DepthCamera> haptic_from_camera;
  haptic_from_camera.iso.linear() << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
  haptic_from_camera.iso.translation() = Eigen::Vector3d(0.0, 0.8, 0.0);
  const SkinHeights skin = heights_of(depth, camera, haptic_from_camera);
  EXPECT_NEAR(skin.highest({{0.0, 0.0, 0.0}}, 0.05), 0.0, 1e-6);
  EXPECT_NEAR(skin.highest({{0.15, 0.0, 0.0}}, 0.01), 0.1, 1e-6) << "the box";
  EXPECT_NEAR(skin.highest({{0.06, 0.0, 0.0}}, 0.06), 0.1, 1e-6) << "the box is near";
  EXPECT_TRUE(std::isinf(skin.highest({{-0.45, 0.0, 0.0}}, 0.02))) << "not measured";
  EXPECT_TRUE(std::isinf(skin.highest({{9.0, 0.0, -9.0}}, 0.1))) << "outside the map";
}

}  // namespace
}  // namespace telepalp::tracking
