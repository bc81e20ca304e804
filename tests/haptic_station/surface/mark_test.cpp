#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "haptic_station/surface/build/mark_tracker.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr Intrinsics kCamera{320, 240, 525.0, 525.0, 159.5, 119.5};

/// Depth of a trunk at camera x and y; with ribs where `ribs_m` is not 0.
double trunk(double x, double y, double ribs_m) {
  return 0.8 + x * x / 1.2 + y * y / 0.5 + ribs_m * std::sin(x / 0.016) * std::cos(y / 0.02 + 0.4);
}

/// The trunk displaced by `moved_m`, with 1 mm of noise, 0 within `hidden_px` of the middle.
DepthField seen(const Vector3d& moved_m, double ribs_m, std::mt19937_64& random, double hidden_px = 0.0) {
  std::normal_distribution<double> noise(0.0, 0.001);
  DepthField field{.width = kCamera.width, .height = kCamera.height, .z_m = {}, .weight = {}};
  for (int v = 0; v < kCamera.height; ++v)
    for (int u = 0; u < kCamera.width; ++u) {
      const double x = (u - kCamera.cx) / kCamera.fx;
      const double y = (v - kCamera.cy) / kCamera.fy;
      double z = 0.8;
      for (int i = 0; i < 5; ++i) z = moved_m.z() + trunk(x * z - moved_m.x(), y * z - moved_m.y(), ribs_m);
      const bool hidden = std::hypot(u - kCamera.cx, v - kCamera.cy) < hidden_px;
      field.z_m.push_back(hidden ? 0.0F : static_cast<float>(z + noise(random)));
    }
  return field;
}

/// A tracker that has seen the trunk at rest, with one mark: an object 50 mm under (10, -10) mm.
struct Watched {
  explicit Watched(double with_ribs_m) : ribs_m(with_ribs_m) {
    MarkLines lines;
    lines[3] = MarkLine{.point = {0.01, -0.01, 0.85}, .up = {0.0, 0.0, -1.0}};
    tracker.watch(lines);
    for (int i = 0; i < 10; ++i) add(Vector3d::Zero());
  }
  void add(const Vector3d& moved_m, double hidden_px = 0.0) {
    const DepthField field = seen(moved_m, ribs_m, random, hidden_px);
    tracker.add(field, field, kCamera, kFrame_s);
  }
  /// Moves to `moved_m` over a second, and stays there for one.
  void move_to(const Vector3d& moved_m) {
    for (int i = 1; i <= 60; ++i) add(std::min(1.0, i / 30.0) * moved_m);
  }
  [[nodiscard]] const SkinMark& mark() const { return tracker.marks()[3]; }

  double ribs_m;
  std::mt19937_64 random{3};
  MarkTracker tracker;
};

TEST(SkinMark, LiesOnTheSkinAboveTheObject) {
  Watched watched(0.004);
  watched.add(Vector3d::Zero());
  const SkinMark& mark = watched.mark();
  EXPECT_TRUE(mark.seen && mark.slide_seen);
  EXPECT_NEAR(mark.at.x(), 0.01, 0.001);
  EXPECT_NEAR(mark.at.y(), -0.01, 0.001);
  EXPECT_NEAR(mark.at.z(), trunk(0.01, -0.01, 0.004), 0.001);
  EXPECT_LT(mark.normal.z(), -0.8) << "towards the camera";
  EXPECT_FALSE(watched.tracker.marks()[0].watched);
}

TEST(SkinMark, FollowsABodyThatRisesAndSlides) {
  for (const Vector3d& moved : {Vector3d(0, 0, -0.01), Vector3d(0.02, 0, 0), Vector3d(0, -0.02, 0.005)}) {
    Watched watched(0.004);
    watched.move_to(moved);
    EXPECT_TRUE(watched.mark().seen && watched.mark().slide_seen);
    EXPECT_LE((watched.mark().moved_m - moved).norm(), 0.0015) << moved.transpose();
    EXPECT_LE(watched.mark().sigma_slide_m, 0.001);
    EXPECT_LE(watched.mark().sigma_normal_m, 0.0005);
  }
}

TEST(SkinMark, SaysThatASmoothBodyDoesNotTellItsSlide) {
  Watched watched(0.0);
  watched.move_to({0.02, 0.0, -0.01});
  EXPECT_TRUE(watched.mark().seen);
  EXPECT_FALSE(watched.mark().slide_seen);
  EXPECT_GT(watched.mark().sigma_slide_m, 0.001) << "and how little it is known";
  EXPECT_LE(watched.mark().moved_m.head<2>().norm(), 0.001) << "it stays";
  EXPECT_NEAR(watched.mark().moved_m.z(), -0.01, 0.001) << "its rise is still measured";
}

TEST(SkinMark, IsHeldWhileItsSkinIsHidden) {
  Watched watched(0.004);
  watched.move_to({0.0, 0.0, -0.01});
  const Vector3d before_m = watched.mark().moved_m;
  for (int i = 0; i < 30; ++i) watched.add({0.0, 0.0, 0.01}, 40.0);
  EXPECT_FALSE(watched.mark().seen);
  EXPECT_EQ(watched.mark().moved_m, before_m);
  for (int i = 0; i < 30; ++i) watched.add({0.0, 0.0, 0.01});
  EXPECT_TRUE(watched.mark().seen);
  EXPECT_NEAR(watched.mark().moved_m.z(), 0.01, 0.001);
}

TEST(SkinMark, WithoutAnySkinIsNotSeenAndNothingIsMadeUp) {
  MarkTracker tracker;
  MarkLines lines;
  lines[0] = MarkLine{.point = {0.0, 0.0, 0.85}, .up = {0.0, 0.0, -1.0}};
  lines[1] = MarkLine{.point = {5.0, 0.0, 0.85}, .up = {0.0, 0.0, -1.0}};  // beside the image
  lines[2] = MarkLine{.point = {0.0, 0.0, -0.5}, .up = {0.0, 0.0, -1.0}};  // behind the camera
  tracker.watch(lines);
  const DepthField nothing{.width = 320, .height = 240, .z_m = std::vector<float>(320 * 240, 0.0F), .weight = {}};
  for (int i = 0; i < 30; ++i) tracker.add(nothing, nothing, kCamera, kFrame_s);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_FALSE(tracker.marks()[i].seen || tracker.marks()[i].slide_seen);
    EXPECT_TRUE(tracker.marks()[i].moved_m.isZero());
  }
}

}  // namespace
}  // namespace telepalp::surface
