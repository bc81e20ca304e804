#include "haptic_station/solids/solid_picture.h"

#include <gtest/gtest.h>

#include <numbers>

#include "haptic_station/solids/polish.h"
#include "tests/haptic_station/solids/tree_of.h"

namespace telepalp::solids {
namespace {

constexpr std::array<std::uint8_t, 3> kRed{200, 0, 0};
constexpr std::array<std::uint8_t, 3> kBlue{0, 0, 200};

struct Pixel {
  int r, g, b;
  [[nodiscard]] bool white() const { return r == 255 && g == 255 && b == 255; }
};
Pixel pixel(const ColorImage& image, int u, int v) {
  const auto at = 3 * static_cast<std::size_t>(v * image.width + u);
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

int drawn(const ColorImage& image) {
  int count = 0;
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) count += pixel(image, u, v).white() ? 0 : 1;
  return count;
}

TEST(SolidPicture, ABallIsADiscOfItsSize) {
  const auto ball = tree_of("sphere 0.05");
  const std::array painted{PaintedSolid{ball.get(), kRed}};
  const ColorImage image = picture_of(painted, {.width_m = 0.2, .side_px = 200});
  EXPECT_EQ(image.width, 200);
  EXPECT_NEAR(drawn(image), std::numbers::pi * 50.0 * 50.0, 80.0);
  EXPECT_TRUE(pixel(image, 2, 2).white());
  EXPECT_GT(pixel(image, 100, 100).r, pixel(image, 100, 52).r) << "the light comes from the eye";
}

TEST(SolidPicture, TheNearerSolidHidesTheOther) {
  const auto near = tree_of("tr 0 0.05 0 sphere 0.02");
  const auto far = tree_of("tr 0 -0.05 0 sphere 0.04");
  const std::array painted{PaintedSolid{far.get(), kBlue}, PaintedSolid{near.get(), kRed}};
  const ColorImage above = picture_of(painted, {.width_m = 0.2, .side_px = 100});
  EXPECT_GT(pixel(above, 50, 50).r, 0);
  EXPECT_EQ(pixel(above, 50, 50).b, 0);
  EXPECT_GT(pixel(above, 65, 50).b, 0) << "beside the near ball the far one is seen";
  const ColorImage below = picture_of(painted, {.towards = Eigen::Vector3d::UnitY(), .width_m = 0.2, .side_px = 100});
  EXPECT_GT(pixel(below, 50, 50).b, 0);
}

TEST(SolidPicture, LeftAndUpInThePictureAreThoseOfTheBody) {
  const auto ball = tree_of("tr 0.06 0 -0.06 sphere 0.01");  // to the patient's left and towards the head
  const std::array painted{PaintedSolid{ball.get(), kRed}};
  const ColorImage image = picture_of(painted, {.width_m = 0.2, .side_px = 100});
  EXPECT_FALSE(pixel(image, 80, 20).white()) << "the head is up, the patient's left on the right";
  EXPECT_TRUE(pixel(image, 20, 20).white());
}

TEST(SolidPicture, NothingToDrawIsWhite) { EXPECT_EQ(drawn(picture_of({}, {.side_px = 16})), 0); }

}  // namespace
}  // namespace telepalp::solids
