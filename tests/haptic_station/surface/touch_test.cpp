#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "haptic_station/surface/build/surface_builder.h"
#include "haptic_station/surface/touch/touch.h"
#include "tests/haptic_station/periods.h"
#include "tests/haptic_station/surface/analytic_surface.h"
#include "tests/haptic_station/surface/shape_error.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;
using testing::AnalyticSurface;

std::shared_ptr<const SurfaceSnapshot> snapshot_of(const AnalyticSurface& surface, const SurfaceSettings& settings = {},
                                                   SessionTime captured = session_time(1)) {
  const Intrinsics camera = testing::camera_with_spacing(0.8, 0.0015);
  return build_snapshot(testing::render(surface, camera, {}), camera, captured, std::nullopt, settings);
}

TEST(Touch, OnAShapeKnownByFormulaTheProxyAndNormalAreRight) {
  for (const auto& shape : testing::smooth_shapes()) {
    const testing::ShapeError error = testing::shape_error(*shape, SurfaceSettings{}, {});
    EXPECT_GT(error.points, 30) << shape->name();
    EXPECT_LT(error.position_rms_m, 10e-6) << shape->name();
    EXPECT_LT(error.normal_rms_deg, 0.2) << shape->name();
  }
}

/// Time until a displayed surface that is 60 mm too low has risen to a device 40 mm above it, and its speed then.
struct Meeting {
  double after_s = 0.0;
  double speed_m_per_s = 0.0;
};
Meeting meeting(const FollowLimits& limits) {
  SurfaceFollower skin{limits};
  const Vector3d up = Vector3d::UnitY();
  skin.take_over(-0.06 * up, up, Vector3d::Zero(), up);
  Meeting met;
  double gap_m = 0.04;
  for (; gap_m > 0.0 && met.after_s < 2.0; met.after_s += kTick_s) {
    skin.advance(Vector3d::Zero(), up, 0.0, gap_m, kTick_s);
    met.speed_m_per_s = skin.velocity_m_per_s().y();
    gap_m -= met.speed_m_per_s * kTick_s;
  }
  return met;
}

TEST(SurfaceFollower, ApproachesFasterWhereItGivesNoForceAndMeetsTheDeviceSlowly) {
  const FollowLimits limits;
  const Meeting met = meeting(limits);
  EXPECT_LT(met.after_s, 0.5) << "50 mm/s would take 0.8 s";
  EXPECT_NEAR(met.speed_m_per_s, limits.speed_m_per_s, 0.005);
  const Meeting slow = meeting({.speed_in_gap_m_per_s = limits.speed_m_per_s});
  EXPECT_GT(slow.after_s, 0.8);
}

/// If the displayed share grew later, over a deep device, the skin's spring would gain energy that the hand did not
/// give.
TEST(Touch, AContactThatBeginsInTheBodyHasItsWholeShareWhileItsDepthIsZero) {
  const auto shapes = testing::smooth_shapes();
  const AnalyticSurface& shape = *shapes.front();
  const auto snapshot = snapshot_of(shape);
  Touch touch;
  touch.adopt(*snapshot, snapshot->captured);
  const Point<DepthCamera> device{{0.0, 0.0, shape.depth_along(0.0, 0.0) + 0.04}};
  const TouchSample first = touch.step(device, snapshot->captured, 0.0005);
  ASSERT_TRUE(first.in_body);
  EXPECT_NEAR(first.distance_m, 0.0, 1e-9);
  EXPECT_GT(first.newest_above_m, 0.03);
  EXPECT_GT(first.coverage, 0.99);
}

/// Support of a contact that begins on a snapshot 1.3 s old: on the tick at which the contact begins, and one tick
/// later, after a new snapshot was adopted.
struct ShareOnReturn {
  double before = 0.0;
  double after = 0.0;
};
ShareOnReturn share_on_return(bool felt) {
  const auto shapes = testing::smooth_shapes();
  const AnalyticSurface& shape = *shapes.front();
  const auto old = snapshot_of(shape);
  const auto newest = snapshot_of(shape, {}, old->captured + from_seconds(1.3));
  Touch touch;
  touch.adopt(*old, old->captured);
  const auto step_at = [&](double depth_m, double at_s) {
    const Point<DepthCamera> device{{0.0, 0.0, shape.depth_along(0.0, 0.0) + depth_m}};
    return touch.step(device, old->captured + from_seconds(at_s), 0.0005, felt);
  };
  (void)step_at(-0.001, 1.2995);
  const TouchSample before = step_at(0.001, 1.3);
  EXPECT_TRUE(before.in_body);
  touch.adopt(*newest, newest->captured);
  return {.before = before.coverage, .after = step_at(0.001, 1.3005).coverage};
}

TEST(Touch, AContactThatIsNotFeltHasItsWholeShareOnceImagesReturn) {
  const ShareOnReturn share = share_on_return(false);
  EXPECT_LT(share.before, 0.5) << "the old image counts little";
  EXPECT_GT(share.after, 0.99);
}

TEST(Touch, AContactThatIsFeltRegainsItsShareGradually) {
  const ShareOnReturn share = share_on_return(true);
  EXPECT_NEAR(share.after - share.before, 0.0005 / kLetGoOver_s, 1e-9);
}

/// What a device that rests 2 mm deep feels while the patient lies down and the displayed skin falls.
struct Falling {
  double fastest_m_per_s = 0.0;
  double pull_m = 0.0;        ///< greatest distance of the proxy below the device: a force into the body
  double least_cosine = 1.0;  ///< of the normals in contact with the skin's
  bool ends = false;
};
Falling falling_skin(const SurfaceSnapshot& before, const SurfaceSnapshot& lower, double depth_m) {
  constexpr int kFalls = 200;
  const Vector3d up = -Vector3d::UnitZ();
  Touch touch({}, follow_limits(300.0));
  touch.adopt(before, before.captured);
  Falling got;
  for (int tick = 0; tick < 600; ++tick) {
    if (tick == kFalls) touch.adopt(lower, lower.captured);
    const Point<DepthCamera> device{{0.0, 0.0, 0.8 + std::min(5e-5 * tick - 0.005, depth_m)}};
    const TouchSample felt = touch.step(device, before.captured + from_seconds(tick * kTick_s), kTick_s);
    got.fastest_m_per_s = std::max(got.fastest_m_per_s, -felt.surface_velocity_m_per_s);
    got.pull_m = std::max(got.pull_m, -up.dot(felt.proxy.m - device.m));
    if (felt.in_body) got.least_cosine = std::min(got.least_cosine, felt.normal.dot(up));
    got.ends = !felt.in_body && tick > kFalls;
  }
  return got;
}

TEST(Touch, ASkinThatMovesAwayDoesNotPullTheDeviceAlong) {
  const auto before = snapshot_of(*testing::plane({0.0, 0.0, 0.8}, -Vector3d::UnitZ()));
  const auto lower =
      snapshot_of(*testing::plane({0.0, 0.0, 0.83}, -Vector3d::UnitZ()), {}, before->captured + from_seconds(0.1));
  for (int i = 0; i < 20; ++i) {
    const Falling got = falling_skin(*before, *lower, 0.002 + 1e-5 * i);
    EXPECT_GT(got.fastest_m_per_s, 0.15);
    EXPECT_LE(got.pull_m, 0.0) << i;
    EXPECT_GT(got.least_cosine, 0.9) << i;
    EXPECT_TRUE(got.ends) << i;
  }
}

TEST(GridSurface, TheGradientIsThatOfF) {
  for (const auto& shape : testing::smooth_shapes()) {
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
