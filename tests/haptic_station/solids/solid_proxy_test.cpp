#include "haptic_station/solids/solid_proxy.h"

#include <gtest/gtest.h>

#include "haptic_station/solids/polish.h"
#include "tests/haptic_station/solids/random_solid.h"
#include "tests/haptic_station/solids/tree_of.h"

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;

/// The last of `ticks` steps along a straight line.
ProxyAt driven(SolidProxy& proxy, const SolidTree& tree, const Vector3d& from, const Vector3d& to, int ticks) {
  ProxyAt at;
  for (int i = 0; i <= ticks; ++i) at = proxy.step(tree, from + (to - from) * i / ticks);
  return at;
}

TEST(SolidProxy, LiesOnASphereAboveTheDevice) {
  const auto tree = tree_of("sphere 0.05");
  SolidProxy proxy;
  const ProxyAt at = driven(proxy, *tree, {0.0, 0.1, 0.0}, {0.0, 0.04, 0.0}, 500);
  EXPECT_NEAR(at.depth_m, 0.01, 1e-6);
  EXPECT_LT((at.at - Vector3d(0.0, 0.05, 0.0)).norm(), 2e-6);
}

TEST(SolidProxy, SlidesRoundATorusToThePointNearestToTheDevice) {
  const auto tree = tree_of("torusx 0.18 0.009");
  SolidProxy proxy;
  (void)driven(proxy, *tree, {0.0, 0.2, 0.0}, {0.0, 0.186, 0.0}, 500);
  const Vector3d to(0.003, 0.18 * std::cos(0.3) * 1.02, 0.18 * std::sin(0.3) * 1.02);
  const ProxyAt at = driven(proxy, *tree, {0.0, 0.186, 0.0}, to, 2000);
  const SolidAt exact = solid_at(*tree, to);
  EXPECT_LT((at.at - (to - exact.m * exact.gradient)).norm(), 1e-5);
}

TEST(SolidProxy, RestsInTheCreaseBetweenTwoSpheres) {
  const auto tree = tree_of("+ tr -0.02 0 0 sphere 0.025 tr 0.02 0 0 sphere 0.025");
  SolidProxy proxy;
  double worst_m = 0.0;
  (void)driven(proxy, *tree, {0.001, 0.05, 0.0}, {0.001, 0.005, 0.0}, 1000);
  Vector3d last = proxy.step(*tree, {0.001, 0.005, 0.0}).at;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d now = proxy.step(*tree, {0.001, 0.005, 0.0}).at;
    worst_m = std::max(worst_m, (now - last).norm());
    last = now;
  }
  EXPECT_LT((last - Vector3d(0.0, 0.015, 0.0)).norm(), 1e-5);
  EXPECT_LT(worst_m, 1e-6) << "the proxy chatters between the faces";
}

TEST(SolidProxy, ATickThatCrossesAThinWallIsHeldOnTheSideOfEntry) {
  const auto tree = tree_of("box 0.1 0.00005 0.1");
  SolidProxy proxy;
  (void)proxy.step(*tree, {0.0, 0.02, 0.0});
  const ProxyAt at = proxy.step(*tree, {0.0, -0.02, 0.0});
  EXPECT_NEAR(at.at.y(), 0.00005, 2e-6);
  EXPECT_NEAR(at.depth_m, 0.02005, 2e-6);
}

TEST(SolidProxy, NeverLiesInsideAndLetsGoOutside) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    RandomSolid random(seed);
    const auto tree = tree_of(random.tree(static_cast<int>(seed % 4)));
    SolidProxy proxy;
    Vector3d device(0.4, 0.4, 0.4);
    for (int leg = 0; leg < 12; ++leg) {
      const Vector3d to = leg % 4 == 3
                              ? Vector3d(0.4, 0.4, 0.4)
                              : Vector3d(random.number(-0.1, 0.1), random.number(-0.1, 0.1), random.number(-0.1, 0.1));
      const Vector3d from = device;
      for (int i = 1; i <= 500; ++i) {
        device = from + (to - from) * i / 500.0;
        const ProxyAt at = proxy.step(*tree, device);
        ASSERT_TRUE(at.at.allFinite()) << "seed " << seed;
        ASSERT_GE(solid_at(*tree, at.at).m, -1e-3) << "seed " << seed << " leg " << leg << " tick " << i;
      }
      if (leg % 4 != 3) continue;
      EXPECT_EQ(proxy.step(*tree, device).depth_m, 0.0) << "seed " << seed;
    }
  }
}

TEST(SolidProxy, GivesNoMoreEnergyThanItTakesOverAnyClosedPath) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RandomSolid random(seed);
    const auto tree = tree_of(random.tree(static_cast<int>(seed % 3)));
    SolidProxy proxy;
    const Vector3d home(0.3, 0.3, 0.3);
    double taken_J = 0.0;
    Vector3d device = home;
    Vector3d force_N = Vector3d::Zero();
    for (int leg = 0; leg < 6; ++leg) {
      const Vector3d from = device;
      const Vector3d to =
          leg == 5 ? home : Vector3d(random.number(-0.1, 0.1), random.number(-0.1, 0.1), random.number(-0.1, 0.1));
      for (int i = 1; i <= 2000; ++i) {
        const Vector3d next = from + (to - from) * i / 2000.0;
        const ProxyAt at = proxy.step(*tree, next);
        const Vector3d now_N = 800.0 * at.depth_m * at.outwards;
        taken_J -= 0.5 * (force_N + now_N).dot(next - device);
        force_N = now_N;
        device = next;
      }
    }
    EXPECT_GE(taken_J, -2e-3) << "seed " << seed;
  }
}

}  // namespace
}  // namespace telepalp::solids
