#include "haptic_station/ultrasound/b_mode.h"

#include <gtest/gtest.h>

#include "haptic_station/solids/polish.h"

namespace telepalp::ultrasound {
namespace {

using effects::Echo;
using effects::SolidLayer;
using Layers = std::vector<std::shared_ptr<const SolidLayer>>;

constexpr Echo kBone{.impedance_MRayl = 6.0, .attenuation_dB_per_cm = 40.0, .scatter = 0.1};
constexpr Echo kCyst{.impedance_MRayl = 1.55, .attenuation_dB_per_cm = 0.1, .scatter = 0.0};

std::shared_ptr<const SolidLayer> layer(const std::string& polish, const Echo& echo) {
  return std::make_shared<const SolidLayer>(
      SolidLayer{"layer", *solids::build_tree(*solids::parse_polish(polish, "test")), echo});
}

/// Mean brightness of columns [left, right) and rows [top, bottom).
double mean(const BModeImage& image, int left, int right, int top, int bottom) {
  double sum = 0.0;
  for (int v = top; v < bottom; ++v)
    for (int u = left; u < right; ++u) sum += image.gray[static_cast<std::size_t>(v * image.side_px + u)];
  return sum / ((right - left) * (bottom - top));
}

int row_of(double depth_m) { return static_cast<int>(depth_m / 0.10 * 256.0); }

TEST(BMode, ABoundaryIsBrightAtItsDepth) {
  const BModeImage image = b_mode(Layers{layer("plane 0 1 0 -0.05", kBone)}, {});
  int brightest = 0;
  for (int v = 1; v < 256; ++v)
    if (mean(image, 0, 256, v, v + 1) > mean(image, 0, 256, brightest, brightest + 1)) brightest = v;
  EXPECT_NEAR(brightest, row_of(0.05), 1);
  EXPECT_NEAR(mean(image, 0, 256, brightest, brightest + 1), 255.0 * (1.0 - 4.9 / 60.0), 2.0)
      << "bone reflects a third of the energy: -4.9 dB";
}

TEST(BMode, ARibCastsAShadow) {
  const BModeImage image = b_mode(Layers{layer("tr 0 -0.02 0 cylinderz 0.008 0.05", kBone)}, {});
  const double behind = mean(image, 108, 148, row_of(0.04), 256);
  const double beside = mean(image, 10, 60, row_of(0.04), 256);
  EXPECT_LT(behind, 0.05 * beside);
  EXPECT_GT(beside, 40.0);
}

TEST(BMode, ACystIsDarkAndWhatLiesBehindItIsEnhanced) {
  const BModeImage image = b_mode(Layers{layer("tr 0 -0.04 0 sphere 0.015", kCyst)}, {});
  EXPECT_LT(mean(image, 118, 138, row_of(0.032), row_of(0.048)), 2.0);
  EXPECT_GT(mean(image, 118, 138, row_of(0.07), 256), 1.1 * mean(image, 10, 40, row_of(0.07), 256));
}

TEST(BMode, TheGainOverDepthEvensOutHomogeneousTissue) {
  const BModeImage image = b_mode(Layers{}, {});
  EXPECT_NEAR(mean(image, 0, 256, 0, 64), mean(image, 0, 256, 192, 256), 3.0);
}

TEST(BMode, SpeckleIsFixedToTheBody) {
  constexpr double kPitch_m = 0.06 / 256.0;
  const Layers layers{layer("tr 0 -0.04 0 sphere 0.015", {.scatter = 0.9})};
  const BModeImage image = b_mode(layers, {});
  const BModeImage moved = b_mode(layers, {.at = {16.0 * kPitch_m, 0.0, 0.0}});
  int differ = 0;
  for (std::size_t v = 0; v < 256; ++v)
    for (std::size_t u = 0; u + 16 < 256; ++u)
      if (image.gray[v * 256 + u + 16] != moved.gray[v * 256 + u]) ++differ;
  EXPECT_LT(differ, 256 * 240 / 100) << "grains at whose border the last digit decides";
}

TEST(BMode, ALayerIsImagedWhereItHasMovedAndItsSpeckleGoesWithIt) {
  const auto ball = layer("tr 0 -0.03 0 sphere 0.02", {.scatter = 0.9});
  const BModeImage rested = b_mode(Layers{ball}, {.at = {0.0, 0.01, 0.0}});
  const BModeImage moved = b_mode(std::vector<PlacedLayer>{{ball.get(), {0.0, -0.01, 0.0}}}, {});
  int differ = 0;
  for (std::size_t i = 0; i < rested.gray.size(); ++i)
    if (rested.gray[i] != moved.gray[i]) ++differ;
  EXPECT_LT(differ, 256 * 256 / 50) << "grains at whose border the last digit decides";
}

TEST(BMode, TheSameInputGivesTheSameImage) {
  const Layers layers{layer("+ tr 0 -0.03 0 sphere 0.01 tr 0.02 -0.05 0 box 0.01 0.01 0.01", kBone)};
  EXPECT_EQ(b_mode(layers, {}).gray, b_mode(layers, {}).gray);
}

TEST(BMode, OfTwoLayersThatOverlapTheLaterOneCounts) {
  const auto outer = layer("tr 0 -0.04 0 sphere 0.03", {.scatter = 1.0});
  const auto inner = layer("tr 0 -0.04 0 sphere 0.01", kCyst);
  const auto middle = [](const BModeImage& image) { return mean(image, 123, 133, row_of(0.037), row_of(0.043)); };
  EXPECT_LT(middle(b_mode(Layers{outer, inner}, {})), 2.0);
  EXPECT_GT(middle(b_mode(Layers{inner, outer}, {})), 60.0);
}

}  // namespace
}  // namespace telepalp::ultrasound
