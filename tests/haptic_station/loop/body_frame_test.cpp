#include "haptic_station/loop/body_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "haptic_station/loop/plane_snapshot.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::loop {
namespace {

using Eigen::Vector3d;

/// A level skin at height 0, with one mark on it.
PlaneSnapshot marked(bool seen, double risen_m = 0.0) {
  PlaneSnapshot snapshot(Vector3d::Zero(), Vector3d::UnitY(), 1.0);
  snapshot.marks[0] = {.watched = true, .seen = seen, .normal = Vector3d::UnitY(), .moved_m = {0.0, risen_m, 0.0}};
  return snapshot;
}

/// The skin under the device is displayed `low_m` below the measured skin.
surface::TouchSample displayed(bool in_body, double low_m) {
  surface::TouchSample touch;
  touch.valid = true;
  touch.in_body = in_body;
  touch.normal = Vector3d::UnitY();
  touch.newest_above_m = low_m;
  touch.foot.m = -low_m * Vector3d::UnitY();
  return touch;
}

class BodyFrameOver : public ::testing::TestWithParam<bool> {};  // the parameter: the mark is seen

TEST_P(BodyFrameOver, AContactBeginsWithTheObjectsAsDeepBelowTheDisplayedSkinAsBelowTheMeasuredOne) {
  const PlaneSnapshot snapshot = marked(GetParam(), 0.004);
  BodyFrame body{surface::FollowLimits{}};
  body.adopt(snapshot, {});
  const effects::Placements& placed = body.step(displayed(true, 0.06), kTick_s);
  EXPECT_NEAR(placed[0].moved.v.y(), 0.004 - 0.06, 1e-5);
  EXPECT_TRUE(placed[1].moved.v.isZero()) << "there is no second object";
}

TEST_P(BodyFrameOver, TheLoweredObjectsRiseToTheirPlacesAsFastAsTheSkinAndNoFaster) {
  const PlaneSnapshot snapshot = marked(GetParam());
  const surface::FollowLimits limits;
  BodyFrame body{limits};
  surface::SurfaceFollower skin{limits};
  skin.take_over(Vector3d{0.0, -0.06, 0.0}, Vector3d::UnitY(), Vector3d::Zero(), Vector3d::UnitY());
  body.adopt(snapshot, {});
  double fastest = 0.0;
  double apart_m = 0.0;
  Vector3d object_m;
  for (int tick = 0; tick < 6000; ++tick) {
    surface::TouchSample touch = displayed(true, skin.lag_m().y());
    touch.surface_velocity_m_per_s = skin.velocity_m_per_s().y();
    const effects::Placement placed = body.step(touch, kTick_s)[0];
    skin.advance(Vector3d::Zero(), Vector3d::UnitY(), 0.0, 0.0, kTick_s);
    object_m = placed.moved.v;
    fastest = std::max(fastest, placed.velocity.v.norm());
    apart_m = std::max(apart_m, std::abs(object_m.y() + skin.lag_m().y()));
  }
  EXPECT_LT(apart_m, 1e-6) << "skin and object rise together";
  EXPECT_LE(fastest, limits.speed_m_per_s * 1.0001);
  EXPECT_NEAR(object_m.y(), 0.0, 1e-6);
}

/// A contact that ends and begins again while the skin still rises must not lower the objects twice.
TEST_P(BodyFrameOver, TheSecondOfTwoContactsInQuickSuccessionFindsTheObjectAsDeepBelowTheSkin) {
  const PlaneSnapshot snapshot = marked(GetParam());
  BodyFrame body{surface::FollowLimits{}};
  body.adopt(snapshot, {});
  (void)body.step(displayed(true, 0.06), kTick_s);
  (void)body.step(displayed(false, 0.05), kTick_s);
  EXPECT_NEAR(body.step(displayed(true, 0.05), kTick_s)[0].moved.v.y(), -0.05, 1e-5);
}

/// Another hand lies on the skin above the object, and the device begins a contact with it.
TEST(BodyFrame, AHiddenObjectStaysWhenAContactBeginsAboveItsSkin) {
  const PlaneSnapshot snapshot = marked(false);
  BodyFrame body{surface::FollowLimits{}};
  body.adopt(snapshot, {});
  surface::TouchSample above = displayed(true, 0.036);
  above.foot.m = {0.0, 0.06, 0.0};
  EXPECT_TRUE(body.step(above, kTick_s)[0].moved.v.isZero());
}

/// After a restart the mark is not known for ten images.
TEST(BodyFrame, AnObjectWhoseSkinHasNotBeenSeenYetIsLoweredWithTheDisplayedSkin) {
  PlaneSnapshot snapshot = marked(false);
  snapshot.marks[0].normal.setZero();
  BodyFrame body{surface::FollowLimits{}};
  body.adopt(snapshot, {});
  EXPECT_NEAR(body.step(displayed(true, 0.06), kTick_s)[0].moved.v.y(), -0.06, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(AMark, BodyFrameOver, ::testing::Bool(),
                         [](const auto& mark) { return mark.param ? "Seen" : "Unseen"; });

}  // namespace
}  // namespace telepalp::loop
