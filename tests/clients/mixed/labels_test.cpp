#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "clients/mixed/device/device_mask.h"
#include "clients/mixed/hand/grasping_area.h"
#include "clients/mixed/hand/hand_colour.h"
#include "clients/mixed/hand/morphology.h"
#include "clients/mixed/scene/desk_scene.h"
#include "tests/clients/mixed/desk_truth.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Mask mask_of(const std::vector<std::string>& rows) {
  Mask mask(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      mask.on[mask.index(x, y)] = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#' ? 1 : 0;
  return mask;
}

std::vector<std::string> rows_of(const Mask& mask) {
  std::vector<std::string> rows;
  for (int y = 0; y < mask.height; ++y) {
    rows.emplace_back();
    for (int x = 0; x < mask.width; ++x) rows.back() += mask.at(x, y) ? '#' : '.';
  }
  return rows;
}

using Rows = std::vector<std::string>;

TEST(Morphology, FillsAHoleButNotABay) {
  EXPECT_EQ(rows_of(with_holes_filled(mask_of({".....", ".###.", ".#.#.", ".###.", "....."}))),
            (Rows{".....", ".###.", ".###.", ".###.", "....."}));
  EXPECT_EQ(rows_of(with_holes_filled(mask_of({"###", "#.#", "#.#"}))), (Rows{"###", "#.#", "#.#"}));
}

TEST(Morphology, ErosionTakesOnePixelAllAroundButNotAtTheImagesBorder) {
  EXPECT_EQ(rows_of(eroded(mask_of({"....", ".###", ".###", ".###"}), 1)), (Rows{"....", "....", "..##", "..##"}));
}

TEST(Morphology, OpeningByReconstructionDropsSpecksAndKeepsThinPartsOfWhatStays) {
  const Mask speckled = mask_of({"##....#.", "##......", "##...###", "########", "##...###"});
  EXPECT_EQ(rows_of(cleaned(speckled, {.erosion_px = 0, .opening_px = 1})),
            (Rows{"##......", "##......", "##...###", "########", "##...###"}));
}

TEST(Morphology, AgreesWithASlowOracleOnRandomMasks) {
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round) {
    Mask mask(17, 13);
    for (auto& on : mask.on) on = random() % 4 != 0 ? 1 : 0;
    for (const int radius : {1, 2}) {
      const Mask fast = eroded(mask, radius);
      for (int y = 0; y < 13; ++y)
        for (int x = 0; x < 17; ++x) {
          bool all = true;
          for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx)
              if (mask.contains(x + dx, y + dy) && !mask.at(x + dx, y + dy)) all = false;
          ASSERT_EQ(fast.at(x, y), all) << x << "," << y << " radius " << radius;
        }
    }
  }
}

TEST(HandColour, HueIsAnAngle) {
  HandColour red{.key = hsi_of({200, 20, 24}), .hue_deviation_rad = 0.1};
  EXPECT_LT(mahalanobis(red, hsi_of({200, 24, 20})), 1.5);  // across the cut at 360 degrees
  EXPECT_GT(mahalanobis(red, hsi_of({20, 200, 24})), 5.0);
  HandColour cyan{.key = {std::numbers::pi, 0.8, 0.5}, .hue_deviation_rad = 0.1};
  EXPECT_NEAR(mahalanobis(cyan, {-std::numbers::pi, 0.8, 0.5}), 0.0, 1e-9);
}

TEST(HandColour, IsDefinedWithoutSaturationAndWithoutLight) {
  const HandColour grey = {.key = hsi_of({128, 128, 128})};
  EXPECT_LT(mahalanobis(grey, hsi_of({130, 128, 127})), 1.0);  // a grey glove: its hue says nothing
  EXPECT_GT(mahalanobis(grey, hsi_of({200, 40, 40})), 3.0);
  EXPECT_TRUE(std::isfinite(mahalanobis(grey, hsi_of({0, 0, 0}))));
  EXPECT_EQ(hsi_of({0, 0, 0}).saturation, 0.0);
  EXPECT_EQ(hsi_of({90, 90, 90}).hue_rad, 0.0);
}

TEST(HandColour, TheTableSaysWhatTheDistanceSays) {
  HandColour hand{.key = hsi_of({205, 150, 120})};
  const HandColourTable table(hand);
  std::mt19937 random(3);
  int differ = 0;
  for (int i = 0; i < 20000; ++i) {
    const Rgb rgb{static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                  static_cast<std::uint8_t>(random())};
    if (table.contains(rgb.data()) != (mahalanobis(hand, hsi_of(rgb)) <= hand.threshold)) ++differ;
  }
  EXPECT_LE(differ, 200);  // 6 of 8 bits a channel
}

TEST(HandColour, AFitToAGlovesPixelsIsItsColour) {
  std::mt19937 random(5);
  std::vector<Rgb> samples;
  for (int i = 0; i < 500; ++i) {
    const int shade = static_cast<int>(random() % 80);
    samples.push_back({static_cast<std::uint8_t>(20 + shade / 8), static_cast<std::uint8_t>(100 + shade),
                       static_cast<std::uint8_t>(40 + shade / 4)});
  }
  const HandColour fit = fit_hand_colour(samples);
  for (const Rgb& rgb : samples) EXPECT_LE(mahalanobis(fit, hsi_of(rgb)), 4.0);
  EXPECT_GT(mahalanobis(fit, hsi_of({168, 122, 82})), fit.threshold);
}

TEST(GraspingArea, HasTheWidthsOfThePaperAndAFloorWhenTheHandlePointsAtTheEye) {
  const View view{kDeskLens, looking_at({{0, -0.6, 0.5}}, {{0, 0, 0.1}})};
  const auto area = grasping_area(view, {{-0.06, 0, 0.1}}, {{0.06, 0, 0.1}});
  ASSERT_TRUE(area);
  const double length = (area->a - area->b).norm();
  EXPECT_NEAR(area->outer_px, std::max(0.75 * length, 40.0), 1e-9);
  EXPECT_NEAR(area->inner_px, 0.2 * area->outer_px, 1e-9);
  const Vector3d forward = view.world_from_eye.iso.linear().col(2);
  const auto along = grasping_area(view, {{0, 0, 0.1}}, {Vector3d(Vector3d(0, 0, 0.1) + 0.1 * forward)});
  ASSERT_TRUE(along);
  EXPECT_NEAR(along->outer_px, 40.0, 1e-9);  // a tenth of the diagonal, 400 px
  EXPECT_FALSE(grasping_area(view, {{0, -2.0, 0.5}}, {{0, 0, 0.1}}));
}

TEST(GraspingArea, WeighsOneInTheInnerHexagonAndFallsToZeroAtTheOuter) {
  const GraspingArea area{{100, 100}, {160, 100}, 40, 8};
  EXPECT_EQ(area.weight_at({130, 103.9}), 1.0);
  EXPECT_EQ(area.weight_at({130, 120.1}), 0.0);
  EXPECT_EQ(area.weight_at({79.9, 100}), 0.0);
  EXPECT_GT(area.weight_at({130, 108}), area.weight_at({130, 114}));
  for (const Vector2d& corner : area.corners(area.outer_px)) EXPECT_NEAR(area.weight_at(corner), 0.0, 1e-9);
  for (const Vector2d& corner : area.corners(area.inner_px)) EXPECT_NEAR(area.weight_at(corner), 1.0, 1e-9);
}

TEST(DeviceMask, WithoutMarginItIsTheImageOfTheRenderedDevice) {
  const StandingDevice device = standing_device();
  const View view{kDeskLens, looking_at({{0.3, -0.5, 0.45}}, {{0, 0.1, 0.1}})};
  const Mask truth = render({.device = device}, view).mask(Label::Device);
  const Mask mask = device_mask(device, view, {});
  const Overlap overlap = overlap_of(mask, truth);
  EXPECT_GE(overlap.recall, 0.999);
  EXPECT_LE(overlap.too_much, 0.03);  // the hulls of the polygons around the cone's rims
}

TEST(DeviceMask, UnderCalibrationErrorTheMarginOfThreeDeviationsCoversTheDevice) {
  const Intrinsics lens{512, 384, 475, 475, 255.5, 191.5};
  const MaskFigures paper = mask_figures(12, lens, paper_margin(), true),
                    ours = mask_figures(12, lens, expected_margin(), true);
  std::printf("recall: paper %.4f, three deviations %.4f; too much %.3f and %.3f\n", paper.recall, ours.recall,
              paper.too_much, ours.too_much);
  EXPECT_GE(ours.recall, 0.995);
  EXPECT_LT(paper.recall, 0.995);
  EXPECT_LE(ours.furthest_m, 0.006);
}

TEST(DeviceMask, ADeviceAtTheEyeOrBehindItHasAMaskWithoutAPixelOutsideTheImage) {
  const StandingDevice device = standing_device();
  for (const Vector3d& eye : {Vector3d(0, 0.05, 0.05), Vector3d(0, 0.4, 0.3), Vector3d(0.0, 0.1, 0.2)}) {
    const View view{kDeskLens, looking_at({eye}, {Vector3d(eye + Vector3d(0.01, 1, 0.02))})};
    const Mask mask = device_mask(device, view, paper_margin());
    EXPECT_EQ(mask.on.size(), 320U * 240U);
  }
}

}  // namespace
}  // namespace telepalp::mixed
