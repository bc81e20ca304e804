#include <gtest/gtest.h>

#include "haptic_station/device/random.h"
#include "haptic_station/effects/inner_cylinder.h"
#include "haptic_station/effects/inner_sphere.h"

namespace telepalp::effects {
namespace {

EffectInput at(const Eigen::Vector3d& device) {
  EffectInput in;
  in.device.m = device;
  return in;
}

InnerCylinder paper_cylinder() { return InnerCylinder({.top_center = {{0.0, -0.03, 0.0}}}); }

TEST(InnerCylinder, PushesUpFromItsUpperFaceWithStiffnessTimesDepth) {
  InnerCylinder cylinder = paper_cylinder();
  const Eigen::Vector3d force_N = cylinder.step(at({0.005, -0.038, 0.0}), 0.0005).N;
  EXPECT_NEAR(force_N.y(), 800.0 * 0.008, 0.005 * 800.0 * 0.008);
  EXPECT_EQ(cylinder.touch(), ObjectTouch::Upper);
}

TEST(InnerCylinder, PushesSidewaysFromItsLateralFace) {
  InnerCylinder cylinder = paper_cylinder();
  const Eigen::Vector3d force_N = cylinder.step(at({0.024, -0.055, 0.0}), 0.0005).N;
  EXPECT_NEAR(force_N.x(), 800.0 * 0.006, 0.005 * 800.0 * 0.006);
  EXPECT_EQ(cylinder.touch(), ObjectTouch::Lateral);
}

TEST(InnerCylinder, ReportsNearAndAway) {
  InnerCylinder cylinder = paper_cylinder();
  EXPECT_EQ(cylinder.step(at({0.0, -0.025, 0.0}), 0.0005).N.norm(), 0.0);
  EXPECT_EQ(cylinder.touch(), ObjectTouch::Near);
  (void)cylinder.step(at({0.0, -0.01, 0.0}), 0.0005);
  EXPECT_EQ(cylinder.touch(), ObjectTouch::None);
}

TEST(InnerCylinder, ForceIsContinuousAndTheGradientOfItsEnergyEverywhere) {
  constexpr std::uint64_t kSeed = 7;
  SCOPED_TRACE(kSeed);
  device::Random random(kSeed);
  InnerCylinder cylinder = paper_cylinder();
  const auto force = [&](const Eigen::Vector3d& p) { return cylinder.step(at(p), 0.0005).N; };
  const auto energy = [&](const Eigen::Vector3d& p) { return (void)force(p), cylinder.energy_J(); };
  constexpr double kStep_m = 1e-6;
  for (int i = 0; i < 20'000; ++i) {
    const Eigen::Vector3d p{random.uniform(-0.04, 0.04), random.uniform(-0.09, -0.02), random.uniform(-0.04, 0.04)};
    if (std::hypot(p.x(), p.z()) < 0.002) continue;  // on the axis the lateral direction is undefined and has no weight
    const Eigen::Vector3d here_N = force(p);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = Eigen::Vector3d::Unit(axis) * kStep_m;
      ASSERT_LE((force(p + step) - here_N).norm(), 0.05) << p.transpose();  // 50 kN/m: no step at any rim
      const double slope = (energy(p + step) - energy(p - step)) / (2.0 * kStep_m);
      ASSERT_NEAR(here_N[axis], -slope, 0.01 + 0.01 * here_N.norm()) << p.transpose();
    }
  }
}

TEST(InnerSphere, PushesOutwardsAndKeepsADirectionAtItsCentre) {
  InnerSphere sphere({.center = {{0.0, -0.05, 0.0}}});
  const Eigen::Vector3d above_N = sphere.step(at({0.0, -0.04, 0.0}), 0.0005).N;
  EXPECT_NEAR(above_N.y(), 8.0, 1e-9);
  EXPECT_EQ(sphere.touch(), ObjectTouch::Upper);
  const Eigen::Vector3d centre_N = sphere.step(at({0.0, -0.05, 0.0}), 0.0005).N;
  EXPECT_TRUE(centre_N.allFinite());
  EXPECT_NEAR(centre_N.y(), 16.0, 1e-6) << "holds the last direction";
}

}  // namespace
}  // namespace telepalp::effects
