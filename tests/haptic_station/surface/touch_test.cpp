#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "haptic_station/surface/surface_builder.h"
#include "haptic_station/surface/touch.h"
#include "tests/haptic_station/surface/analytic_surface.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;
using testing::AnalyticSurface;

constexpr double kSteepestView =
    0.77;  // cosine of 40 degrees: beyond it the sampling is no longer what the shape was given
constexpr double kTick_s = 0.0005;

std::shared_ptr<const SurfaceSnapshot> snapshot_of(const AnalyticSurface& surface,
                                                   const SurfaceSettings& settings = {}) {
  const Intrinsics camera = testing::camera_with_spacing(0.8, 0.0015);
  return build_snapshot(testing::render(surface, camera, {}), camera, session_time(1), std::nullopt, settings);
}

SessionTime at_s(double seconds) { return session_time(1) + from_seconds(seconds); }

/// Presses along a line for `steps` ticks and answers with the last sample.
TouchSample press(Touch& touch, const Vector3d& from, const Vector3d& to, int steps) {
  TouchSample last;
  for (int i = 0; i <= steps; ++i)
    last = touch.step({from + (to - from) * (static_cast<double>(i) / steps)}, at_s(0.1), kTick_s);
  return last;
}

std::vector<std::unique_ptr<AnalyticSurface>> shapes() {
  std::vector<std::unique_ptr<AnalyticSurface>> all;
  all.push_back(testing::plane({0, 0, 0.8}, {0.3, -0.2, -1.0}));
  all.push_back(testing::sphere({0, 0, 0.88}, 0.08));
  all.push_back(testing::sphere({0, 0, 0.85}, 0.05));
  all.push_back(testing::saddle(0.8, 10.0));
  all.push_back(testing::gaussian_bump(0.8, 0.02, 0.04));
  all.push_back(testing::torus({-0.1, 0, 0.85}, 0.1, 0.05));
  return all;
}

TEST(Touch, OnAShapeKnownByFormulaTheProxyAndNormalAreRight) {
  for (const auto& shape : shapes()) {
    const auto snapshot = snapshot_of(*shape);
    ASSERT_NE(snapshot, nullptr);
    double square = 0.0;
    double square_turn = 0.0;
    int count = 0;
    for (double x = -0.03; x <= 0.03; x += 0.0071)
      for (double y = -0.03; y <= 0.03; y += 0.0071) {
        const double z = shape->depth_along((x + 0.02) / 0.8, y / 0.8);
        if (z == 0.0) continue;
        const testing::TrueFoot seen = shape->foot(Vector3d((x + 0.02) / 0.8, y / 0.8, 1.0) * z);
        if (-seen.normal.dot(seen.at.normalized()) < kSteepestView) continue;
        const Vector3d above = Vector3d((x + 0.02) / 0.8 * z, y / 0.8 * z, z) * 0.97;
        Touch touch;
        touch.adopt(*snapshot, at_s(0.1));
        const TouchSample sample = press(touch, above, above * 1.04, 200);
        ASSERT_TRUE(sample.valid) << shape->name() << " " << x << " " << y;
        ASSERT_TRUE(sample.in_body) << shape->name();
        const testing::TrueFoot truth = shape->foot(sample.proxy.m);
        square += truth.distance_m * truth.distance_m;
        square_turn += truth.normal.cross(sample.normal).squaredNorm();
        EXPECT_LT((sample.proxy.m - shape->foot(above * 1.04).at).norm(), 2e-4) << shape->name();
        ++count;
      }
    const double rms_um = 1e6 * std::sqrt(square / count);
    EXPECT_LT(rms_um, 10.0) << shape->name();
    EXPECT_LT(std::sqrt(square_turn / count) * 180.0 / M_PI, 0.2) << shape->name();
  }
}

TEST(GridSurface, TheGradientIsThatOfF) {
  for (const auto& shape : shapes()) {
    const auto snapshot = snapshot_of(*shape);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> side(-0.03, 0.03);
    for (int i = 0; i < 50; ++i) {
      const double x = side(random) / 0.8, y = side(random) / 0.8;
      const double z = shape->depth_along(x, y);
      if (z == 0.0) continue;
      const Vector3d at = Vector3d(x, y, 1.0) * (z + 0.1 * side(random));
      const FieldSample here = snapshot->evaluate(at, Vector3d::Zero(), {});
      if (!here.valid) continue;
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3d step = 2e-5 * Vector3d::Unit(axis);
        const double slope = (snapshot->evaluate(at + step, Vector3d::Zero(), {}).f_m -
                              snapshot->evaluate(at - step, Vector3d::Zero(), {}).f_m) /
                             4e-5;
        EXPECT_NEAR(slope, here.gradient[axis], 2e-3) << shape->name() << " axis " << axis;
      }
    }
  }
}

}  // namespace
}  // namespace telepalp::surface
