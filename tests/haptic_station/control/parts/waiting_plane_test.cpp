#include "haptic_station/control/parts/waiting_plane.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

namespace telepalp::control {
namespace {

constexpr std::optional<double> kNoDemand;

ports::SurfaceContact skin_at(double distance_m) {
  ports::SurfaceContact contact;
  contact.valid = true;
  contact.normal.v = Eigen::Vector3d::UnitY();
  contact.distance_m = distance_m;
  return contact;
}

TEST(WaitingPlane, StartsAtItsPlaceAtOnce) {
  WaitingPlane plane({.height_m = 0.03, .clearance_m = 0.02, .offset_m = 0.001});
  plane.move({{0.0, 0.1, 0.0}}, skin_at(0.05), kNoDemand, 0.0005);  // the skin is at 0.05
  EXPECT_DOUBLE_EQ(plane.height_m(), 0.07);
  EXPECT_DOUBLE_EQ(plane.target_height_m(), 0.071);
}

TEST(WaitingPlane, RisesWithTheSkinAtABoundedSpeed) {
  WaitingPlane plane({.height_m = 0.03, .clearance_m = 0.02, .speed_m_per_s = 0.1});
  plane.move({{0.0, 0.1, 0.0}}, {}, kNoDemand, 0.0005);
  EXPECT_DOUBLE_EQ(plane.height_m(), 0.03) << "without a surface: the height of the settings";
  plane.move({{0.0, 0.1, 0.0}}, skin_at(0.05), kNoDemand, 0.01);
  EXPECT_NEAR(plane.height_m(), 0.031, 1e-12) << "10 ms at 0.1 m/s";
}

TEST(WaitingPlane, ADemandedHeightMovesTheDeviceAndThePlaneStaysBelowIt) {
  WaitingPlane plane({.height_m = 0.03, .clearance_m = 0.02, .offset_m = 0.001, .speed_m_per_s = 0.1});
  const auto move = [&](const std::optional<double>& at_m) {
    plane.move({{0.0, 0.1, 0.0}}, skin_at(0.08), at_m, 0.01);
  };
  move(kNoDemand);
  EXPECT_DOUBLE_EQ(plane.target_height_m(), 0.041) << "2 cm above the skin";
  move(0.09);
  EXPECT_NEAR(plane.target_height_m(), 0.043, 1e-12) << "10 ms at twice the plane's speed";
  for (int i = 0; i < 100; ++i) move(0.09);
  EXPECT_DOUBLE_EQ(plane.target_height_m(), 0.091);
  EXPECT_NEAR(plane.height_m(), 0.07, 1e-12);
  for (int i = 0; i < 100; ++i) move(-0.05);
  EXPECT_DOUBLE_EQ(plane.target_height_m(), -0.049) << "below the settings' height, where the camera sees low skin";
  for (int i = 0; i < 200; ++i) move(std::numeric_limits<double>::quiet_NaN());
  EXPECT_DOUBLE_EQ(plane.target_height_m(), 0.041) << "no number is no demand";
}

}  // namespace
}  // namespace telepalp::control
