#include "haptic_station/control/parts/waiting_plane.h"

#include <gtest/gtest.h>

namespace telepalp::control {
namespace {

ports::SurfaceContact skin_at(double distance_m) {
  ports::SurfaceContact contact;
  contact.valid = true;
  contact.normal.v = Eigen::Vector3d::UnitY();
  contact.distance_m = distance_m;
  return contact;
}

TEST(WaitingPlane, StartsAtItsPlaceAtOnce) {
  WaitingPlane plane({.height_m = 0.03, .clearance_m = 0.02, .offset_m = 0.001});
  plane.move({{0.0, 0.1, 0.0}}, skin_at(0.05), 0.0005);  // the skin is at 0.05
  EXPECT_DOUBLE_EQ(plane.height_m(), 0.07);
  EXPECT_DOUBLE_EQ(plane.target_height_m(), 0.071);
}

TEST(WaitingPlane, RisesWithTheSkinAtABoundedSpeed) {
  WaitingPlane plane({.height_m = 0.03, .clearance_m = 0.02, .speed_m_per_s = 0.1});
  plane.move({{0.0, 0.1, 0.0}}, {}, 0.0005);
  EXPECT_DOUBLE_EQ(plane.height_m(), 0.03) << "without a surface: the height of the settings";
  plane.move({{0.0, 0.1, 0.0}}, skin_at(0.05), 0.01);
  EXPECT_NEAR(plane.height_m(), 0.031, 1e-12) << "10 ms at 0.1 m/s";
}

}  // namespace
}  // namespace telepalp::control
