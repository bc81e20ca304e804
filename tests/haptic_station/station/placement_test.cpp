#include "haptic_station/station/rigs/placement.h"

#include <gtest/gtest.h>

namespace telepalp::station {
namespace {

const Intrinsics kSmallCamera{.width = 64, .height = 48, .fx = 50, .fy = 50, .cx = 32, .cy = 24};

DepthImage flat(std::uint16_t sample) {
  return {.width = 64, .height = 48, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(64 * 48, sample)};
}

TEST(Placement, TheSkinIsOnTheCentralRayAtTheMedianDepth) {
  const auto point = point_under_center(flat(800), kSmallCamera);
  ASSERT_TRUE(point);
  EXPECT_NEAR((point->m - Eigen::Vector3d(0, 0, 0.8)).norm(), 0.0, 1e-12);
}

TEST(Placement, AHoleInTheMiddleIsAvoided) {
  DepthImage depth = flat(800);
  for (int row = 18; row < 30; ++row)
    for (int column = 26; column < 38; ++column) depth.samples[static_cast<std::size_t>(row * 64 + column)] = 0;
  const auto point = point_under_center(depth, kSmallCamera);
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->m.z(), 0.8, 1e-12);
}

TEST(Placement, AnImageWithoutDepthHasNoPatient) { EXPECT_FALSE(point_under_center(flat(0), kSmallCamera)); }

TEST(Placement, AnImageOfOnePixelIsNoCrash) {
  const DepthImage depth{.width = 1, .height = 1, .unit_m = 0.001, .samples = {800}};
  EXPECT_FALSE(point_under_center(depth, {.width = 1, .height = 1, .fx = 1, .fy = 1, .cx = 0, .cy = 0}));
}

}  // namespace
}  // namespace telepalp::station
