#include "support/images/triangle_scan.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace telepalp::images {
namespace {

constexpr int kSide = 24;

std::vector<int> times_covered(const std::vector<std::array<Eigen::Vector2f, 3>>& triangles) {
  std::vector<int> times(kSide * kSide, 0);
  for (const auto& [a, b, c] : triangles)
    scan_triangle(a, b, c, kSide, kSide, [&](int x, int y, float wa, float wb, float wc) {
      ++times.at(static_cast<std::size_t>(y * kSide + x));
      const Eigen::Vector2f at = wa * a + wb * b + wc * c;
      EXPECT_NEAR(at.x(), static_cast<float>(x), 1e-3F);
      EXPECT_NEAR(at.y(), static_cast<float>(y), 1e-3F);
    });
  return times;
}

/// The four triangles between a square's corners and a point in it leave no pixel out, whichever way they turn.
TEST(TriangleScan, TrianglesThatMeetLeaveNoPixelOutAndWeightsGiveThePixelBack) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> inside(2.0F, 20.0F);
  const Eigen::Vector2f corners[] = {{1, 1}, {21, 1}, {21, 21}, {1, 21}};
  for (int run = 0; run < 50; ++run) {
    const Eigen::Vector2f middle(inside(random), inside(random));
    std::vector<std::array<Eigen::Vector2f, 3>> triangles;
    for (int i = 0; i < 4; ++i)
      triangles.push_back(i % 2 == 0 ? std::array{corners[i], corners[(i + 1) % 4], middle}
                                     : std::array{corners[(i + 1) % 4], corners[i], middle});
    const std::vector<int> times = times_covered(triangles);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const int covered = times[static_cast<std::size_t>(y * kSide + x)];
        const bool is_inside = x > 1 && x < 21 && y > 1 && y < 21;
        const bool is_outside = x < 1 || x > 21 || y < 1 || y > 21;
        EXPECT_GE(covered, is_inside ? 1 : 0) << x << " " << y;
        EXPECT_LE(covered, is_outside ? 0 : 4) << x << " " << y;
      }
  }
}

TEST(TriangleScan, CornersFarOutsideAreClippedAndATriangleWithoutAreaHasNoPixel) {
  const float far = 1e12F;
  const std::vector<int> all = times_covered({});
  int pixels = 0;
  scan_triangle({-far, -far}, {far, -far}, {0.0F, far}, kSide, kSide, [&](int, int, float, float, float) { ++pixels; });
  EXPECT_EQ(pixels, kSide * kSide);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(times_covered({{{{1, 1}, {5, 5}, {9, 9}}}, {{{nan, 1}, {5, 5}, {9, 1}}}}), all);
}

}  // namespace
}  // namespace telepalp::images
