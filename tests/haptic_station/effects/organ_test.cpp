#include "haptic_station/effects/organ.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptic_station/device/random.h"
#include "haptic_station/organs/organ_shape.h"
#include "where.h"

namespace telepalp::effects {
namespace {

using Eigen::Vector3d;

const std::string kLiver = TELEPALP_SOURCE_DIR "/deploy/demo_data/organs/visible_human_liver.ply";

EffectInput device_at(const Vector3d& device) {
  EffectInput in;
  in.device.m = device;
  return in;
}

/// A ball of `radius_m` around the origin as a mesh: an octahedron whose faces are divided by four `cuts` times.
models::PointModel ball(double radius_m, int cuts) {
  models::PointModel model;
  const auto add = [&](const Vector3d& p) {
    model.points.push_back((radius_m * p.normalized()).cast<float>());
    return static_cast<std::uint32_t>(model.points.size() - 1);
  };
  const auto face = [&](const auto& self, const Vector3d& a, const Vector3d& b, const Vector3d& c, int left) -> void {
    if (left == 0) {
      model.triangles.push_back({add(a), add(b), add(c)});
      return;
    }
    const Vector3d ab = (a + b).normalized();
    const Vector3d bc = (b + c).normalized();
    const Vector3d ca = (c + a).normalized();
    self(self, a, ab, ca, left - 1);
    self(self, ab, b, bc, left - 1);
    self(self, ca, bc, c, left - 1);
    self(self, ab, bc, ca, left - 1);
  };
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) {
        const Vector3d u = x * Vector3d::UnitX();
        const Vector3d v = y * Vector3d::UnitY();
        const Vector3d w = z * Vector3d::UnitZ();
        x* y* z > 0.0 ? face(face, u, v, w, cuts) : face(face, u, w, v, cuts);
      }
  return model;
}

Organ ball_organ(double radius_m, double cell_m) {
  const auto lattice = organs::signed_distance(ball(radius_m, 5), cell_m, 0.03);
  EXPECT_TRUE(lattice.ok());
  return Organ({.shape = std::make_shared<const solids::DistanceLattice>(*lattice), .stiffness_N_per_m = 800.0});
}

Organ liver() {
  const auto shape = organs::read_organ_shape(kLiver, {});
  EXPECT_TRUE(shape.ok()) << (shape.ok() ? "" : to_string(shape.error()));
  return Organ({.shape = *shape});
}

TEST(Organ, ABallOfTrianglesFeelsAsTheSphereDoes) {
  constexpr double kRadius_m = 0.03;
  Organ organ = ball_organ(kRadius_m, 0.002);
  device::Random random(11);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d way = Vector3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}.normalized();
    const double depth_m = random.uniform(0.0005, 0.015);
    organ.begin(device_at(way));
    const Vector3d force_N = organ.step(device_at((kRadius_m - depth_m) * way), 0.0005).N;
    // The spline lies up to 0.09 mm outside of the ball at 15 mm of depth, its slope is up to 0.6 % less than 1, and
    // the triangles lie 0.01 mm inside.
    ASSERT_NEAR(force_N.dot(way), 800.0 * depth_m, 800.0 * 3e-4) << way.transpose() << " at " << depth_m;
    ASSERT_LE((force_N - force_N.dot(way) * way).norm(), 0.03 * force_N.norm() + 0.01);
  }
}

TEST(Organ, ForceIsTheGradientOfItsEnergyEverywhereInALiver) {
  constexpr std::uint64_t kSeed = 5;
  SCOPED_TRACE(kSeed);
  device::Random random(kSeed);
  Organ organ = liver();
  const auto force = [&](const Vector3d& p) { return organ.step(device_at(p), 0.0005).N; };
  const auto energy = [&](const Vector3d& p) { return (void)force(p), organ.energy_J(); };
  constexpr double kStep_m = 1e-6;
  int inside = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d p{random.uniform(-0.14, 0.06), random.uniform(0.27, 0.46), random.uniform(-0.09, 0.12)};
    organ.begin(device_at(p));
    const Vector3d here_N = force(p);
    if (here_N.norm() > 0.0) ++inside;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d step = Vector3d::Unit(axis) * kStep_m;
      ASSERT_LE((force(p + step) - here_N).norm(), 0.01) << p.transpose();  // 10 kN/m: no step at any ridge
      const double slope = (energy(p + step) - energy(p - step)) / (2.0 * kStep_m);
      ASSERT_NEAR(here_N[axis], -slope, 0.001 + 0.001 * here_N.norm()) << p.transpose();
    }
  }
  EXPECT_GT(inside, 2000);
}

TEST(Organ, ReportsUpperLateralNearAndAway) {
  Organ beside = ball_organ(0.03, 0.003);
  (void)beside.step(device_at({0.025, 0.0, 0.0}), 0.0005);
  EXPECT_EQ(beside.touch(), ObjectTouch::Lateral);
  Organ organ = ball_organ(0.03, 0.003);
  (void)organ.step(device_at({0.0, 0.025, 0.0}), 0.0005);
  EXPECT_EQ(organ.touch(), ObjectTouch::Upper);
  EXPECT_EQ(organ.step(device_at({0.0, 0.036, 0.0}), 0.0005).N.norm(), 0.0);
  EXPECT_EQ(organ.touch(), ObjectTouch::Near);
  (void)organ.step(device_at({0.0, 0.045, 0.0}), 0.0005);
  EXPECT_EQ(organ.touch(), ObjectTouch::None);
}

TEST(Organ, FarAwayAndAtNaNThereIsNoForce) {
  Organ organ = liver();
  for (const double x : {10.0, -1e30, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(organ.step(device_at({x, 0.35, 0.0}), 0.0005).N.norm(), 0.0) << x;
  EXPECT_EQ(Organ().step(device_at({0, 0, 0}), 0.0005).N.norm(), 0.0) << "without a shape";
}

}  // namespace
}  // namespace telepalp::effects
