// Properties of every surface and every movement, checked on seeded random ones.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "haptic_station/surface/build/surface_builder.h"
#include "haptic_station/surface/cloud/cloud_snapshot.h"
#include "haptic_station/surface/touch/touch.h"
#include "tests/haptic_station/periods.h"
#include "tests/haptic_station/surface/analytic_surface.h"
#include "tests/haptic_station/surface/shape_error.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

SessionTime at_s(double seconds) { return session_time(0) + from_seconds(seconds); }

/// 160×120 pixels 1.5 mm apart at 0.8 m.
Intrinsics small_camera() { return {.width = 160, .height = 120, .fx = 533.3, .fy = 533.3, .cx = 79.5, .cy = 59.5}; }

std::vector<CloudPoint> wavy_cloud(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> side(-0.05, 0.05);
  std::vector<CloudPoint> points;
  for (int i = 0; i < 6000; ++i) {
    const double x = side(random);
    const double y = side(random);
    const Vector3d normal(-0.6 * std::cos(60.0 * x) * 0.5, 0.0, -1.0);
    points.push_back(
        {Vector3d(x, y, 0.8 - 0.005 * std::sin(60.0 * x)).cast<float>(), normal.normalized().cast<float>()});
  }
  return points;
}

std::shared_ptr<const CloudSnapshot> snapshot_of(std::vector<CloudPoint> points) {
  CloudShape shape;
  shape.support_m = 0.006;
  return std::make_shared<const CloudSnapshot>(std::move(points), shape, Index::Nanoflann);
}

TEST(TouchProperties, ACloudTurnedAndMovedIsTouchedTheSame) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> any(0.0, 1.0);
    Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
    moved.linear() = Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized().matrix();
    moved.translation() = Vector3d(any(random), any(random), any(random));
    const std::vector<CloudPoint> points = wavy_cloud(seed);
    std::vector<CloudPoint> elsewhere = points;
    for (CloudPoint& point : elsewhere) {
      point.at_m = (moved * point.at_m.cast<double>()).cast<float>();
      point.normal = (moved.linear() * point.normal.cast<double>()).cast<float>();
    }
    const auto here = snapshot_of(points);
    const auto there = snapshot_of(elsewhere);
    for (int i = 0; i < 300; ++i) {
      const Vector3d at(0.01 * any(random), 0.01 * any(random), 0.8 + 0.002 * any(random));
      const FieldSample a = here->evaluate(at, Vector3d::Zero(), {});
      const FieldSample b = there->evaluate(moved * at, Vector3d::Zero(), {});
      ASSERT_EQ(a.valid, b.valid) << "seed " << seed;
      EXPECT_NEAR(a.f_m, b.f_m, 2e-6) << "seed " << seed << ": to the floats' rounding";
      EXPECT_LT((moved.linear() * a.normal - b.normal).norm(), 2e-3) << "seed " << seed;
    }
  }
}

TEST(TouchProperties, ADepthImageOnItsSideIsTouchedTheSame) {
  const Intrinsics camera = small_camera();
  const Intrinsics turned{
      .width = 120, .height = 160, .fx = camera.fy, .fy = camera.fx, .cx = camera.cy, .cy = camera.cx};
  const auto bump = testing::gaussian_bump(0.8, 0.02, 0.04);
  const DepthImage image = testing::render(*bump, camera, {.sigma_m = 0.001, .seed = 3});
  DepthImage side{.width = 120, .height = 160, .unit_m = image.unit_m, .samples = {}};
  for (int u = 0; u < 160; ++u)
    for (int v = 0; v < 120; ++v) side.samples.push_back(image.samples[static_cast<std::size_t>(v * 160 + u)]);
  // Both are evaluated in the middle, because the lattices differ at the border.
  const auto upright = build_snapshot(image, camera, at_s(1.0), std::nullopt, *surface_settings("single-frame"));
  const auto lying = build_snapshot(side, turned, at_s(1.0), std::nullopt, *surface_settings("single-frame"));
  std::mt19937_64 random(4);
  std::normal_distribution<double> any(0.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    const Vector3d at(0.01 * any(random), 0.01 * any(random), 0.78 + 0.002 * any(random));
    const FieldSample a = upright->evaluate(at, Vector3d::Zero(), {});
    const FieldSample b = lying->evaluate({at.y(), at.x(), at.z()}, Vector3d::Zero(), {});
    ASSERT_TRUE(a.valid && b.valid);
    EXPECT_NEAR(a.f_m, b.f_m, 1e-6);
    EXPECT_LT((Vector3d(a.normal.y(), a.normal.x(), a.normal.z()) - b.normal).norm(), 1e-4);
  }
}

TEST(TouchProperties, FinerSamplingConvergesToTheTrueSurface) {
  for (const char* name : {"single-frame", "cloud"})
    for (const auto& shape : testing::smooth_shapes()) {
      if (shape->name() == "plane") continue;  // the plane is exact; only the rounding of samples remains
      const auto settings = *surface_settings(name);
      const double coarse_m = testing::shape_error(*shape, settings, {.spacing_m = 0.0030}).position_rms_m;
      const double fine_m = testing::shape_error(*shape, settings, {.spacing_m = 0.0015}).position_rms_m;
      EXPECT_LT(fine_m, 0.6 * coarse_m + 1e-6) << name << ", " << shape->name();
    }
}

/// Any number that a damaged sensor, file or packet could contain.
double anything(std::mt19937_64& random) {
  const std::uint64_t kind = random() % 5;
  if (kind == 0) return std::bit_cast<double>(random());
  if (kind == 1) return std::numeric_limits<double>::quiet_NaN();
  if (kind == 2) return random() % 2 == 0 ? std::numeric_limits<double>::infinity() : -1e300;
  return std::uniform_real_distribution<double>(-1.0, 2.0)(random);
}

TEST(TouchProperties, ResultsAreFiniteForAnyImageAndAnyDevicePosition) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    std::mt19937_64 random(seed);
    SurfaceBuilder builder{SurfaceSettings{}};
    Touch touch;
    std::shared_ptr<const SurfaceSnapshot> snapshot;
    const Intrinsics camera = small_camera();
    const int kind = static_cast<int>(seed % 3);
    for (int frame = 0; frame < 12; ++frame) {
      DepthImage image{.width = 160, .height = 120, .unit_m = 1e-4, .samples = {}};
      for (int i = 0; i < 160 * 120; ++i) {
        const std::uint16_t chaos = static_cast<std::uint16_t>(random());
        const auto flicker = static_cast<std::uint16_t>(random() % 4 == 0 ? 0U : 7900U + random() % 200U);
        const auto cliff = static_cast<std::uint16_t>((random() % 7 == 0 ? 6000U : 8000U) + random() % 20U);
        image.samples.push_back(kind == 0 ? chaos : (kind == 1 ? flicker : cliff));
      }
      const double t = frame / 30.0;
      auto newer = builder.add(image, camera, at_s(t), std::nullopt);
      if (newer) touch.adopt(*newer, at_s(t));
      if (newer) snapshot = std::move(newer);
      for (int tick = 0; tick < 67; ++tick) {
        const bool sane = random() % 4 != 0;
        const Vector3d at = sane ? Vector3d(0.02 * std::sin(tick), 0.0, 0.79 + 0.0005 * tick)
                                 : Vector3d(anything(random), anything(random), anything(random));
        const TouchSample felt = touch.step({at}, at_s(t + tick * kTick_s), anything(random));
        ASSERT_TRUE(felt.proxy.m.allFinite() || !at.allFinite()) << "seed " << seed;
        ASSERT_TRUE(felt.normal.allFinite() && std::isfinite(felt.uncertainty_m) && std::isfinite(felt.coverage))
            << "seed " << seed;
        ASSERT_FALSE(std::isnan(felt.distance_m)) << "seed " << seed;
        const FieldSample sample = snapshot->evaluate(at, Vector3d::Zero(), {});
        ASSERT_TRUE(sample.gradient.allFinite() && std::isfinite(sample.f_m)) << "seed " << seed;
      }
    }
  }
}

/// A hand that moves at random above and in a bump, pulled back to the bump's middle.
class Wanderer {
 public:
  explicit Wanderer(std::uint64_t seed) : random_(seed) {}
  /// Distance from the bump's axis and height above the true skin [m].
  Vector3d step() {
    std::normal_distribution<double> push(0.0, 1.0);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double reach = axis == 2 ? 0.008 : 0.02;
      velocity_[axis] += kTick_s * (-400.0 * (place_[axis] - middle_[axis])) + 0.012 * push(random_) * reach / 0.02;
      velocity_[axis] *= 0.999;
      place_[axis] += kTick_s * velocity_[axis];
    }
    return place_;
  }

 private:
  std::mt19937_64 random_;
  Vector3d middle_{0.0, 0.0, -0.002};
  Vector3d place_{0.0, 0.0, 0.01};
  Vector3d velocity_ = Vector3d::Zero();
};

TEST(TouchProperties, AMillionRandomStepsNeverPassThroughTheSurface) {
  constexpr int kSteps = 1'000'000;
  constexpr double kSure_m = 0.0010;  // bound on the error by noise, gradual change and the slope of the bump
  const Intrinsics camera = small_camera();
  const auto bump = testing::gaussian_bump(0.8, 0.02, 0.04);
  SurfaceSettings averaged;
  averaged.predict = false;  // the same snapshots are repeated, so prediction is off
  SurfaceBuilder builder{averaged};
  std::vector<std::shared_ptr<const SurfaceSnapshot>> seen;
  for (int frame = 0; frame < 30; ++frame) {
    const testing::RenderSettings noise{.sigma_m = 0.001, .seed = static_cast<std::uint64_t>(frame + 1)};
    auto snapshot = builder.add(testing::render(*bump, camera, noise), camera, at_s(frame / 30.0), std::nullopt);
    if (frame >= 10) seen.push_back(std::move(snapshot));
  }
  TouchSettings settings;
  settings.stale_after_s = 1e9;
  Touch touch(settings);
  Wanderer hand(20);
  double deepest_m = 0.0;
  double worst_proxy_m = 0.0;
  double fastest_m_per_s = 0.0;
  int touched = 0;
  int entries = 0;
  bool was_in = false;
  Vector3d last = Vector3d::Zero();
  for (int tick = 0; tick < kSteps; ++tick) {
    const double t = 1.0 + tick * kTick_s;
    if (tick % 67 == 0) touch.adopt(*seen[static_cast<std::size_t>(tick / 67) % seen.size()], at_s(t));
    const Vector3d place = hand.step();
    const double skin_m = 0.8 - 0.02 * std::exp(-(place.x() * place.x() + place.y() * place.y()) / 0.0032);
    const Vector3d at(place.x(), place.y(), skin_m - place.z());
    if (tick > 0) fastest_m_per_s = std::max(fastest_m_per_s, (at - last).norm() / kTick_s);
    last = at;
    const TouchSample felt = touch.step({at}, at_s(t), kTick_s);
    ASSERT_TRUE(felt.valid) << "step " << tick << " at " << place.transpose();
    ASSERT_TRUE(felt.in_body || place.z() > -kSure_m) << "popped through at step " << tick << ", " << place.z();
    ASSERT_TRUE(!felt.in_body || place.z() < kSure_m) << "sticks at step " << tick << ", " << place.z();
    entries += felt.in_body && !was_in ? 1 : 0;
    was_in = felt.in_body;
    if (!felt.in_body) continue;
    ++touched;
    deepest_m = std::min(deepest_m, place.z());
    worst_proxy_m = std::max(worst_proxy_m, std::abs(bump->foot(felt.foot.m).distance_m));
  }
  EXPECT_GT(touched, kSteps / 4);
  EXPECT_GT(entries, 100);
  EXPECT_LT(deepest_m, -0.012) << "the walk was too shy to tell";
  EXPECT_GT(fastest_m_per_s, 0.3);
  EXPECT_LT(worst_proxy_m, 0.001);
}

}  // namespace
}  // namespace telepalp::surface
