#include "codec/entropy/palette_coding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "codec/levels/disparity_law.h"

namespace telepalp::codec {
namespace {

using Levels = std::vector<std::uint16_t>;

/// A Kinect's levels between 0.5 m and 4 m, in units of `unit_mm`, without a random share of them.
Levels kinect_levels(double unit_mm, double left_out, unsigned seed) {
  std::mt19937 random(seed);
  Levels levels;
  for (int disparity = 1000; disparity > 0; --disparity) {
    const double z_mm = 1.0 / (2.894e-6 * (1091.5 - disparity));
    if (z_mm < 500.0 || z_mm > 4000.0) continue;
    if (std::uniform_real_distribution<>(0.0, 1.0)(random) < left_out) continue;
    levels.push_back(static_cast<std::uint16_t>(std::lround(z_mm) * std::lround(1.0 / unit_mm)));
  }
  std::ranges::sort(levels);
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

std::string coded(const Levels& levels, const LevelPalette& before = {}) {
  std::string body;
  LevelPalette palette;
  palette.levels.insert(palette.levels.end(), levels.begin(), levels.end());
  append_coded_palette(body, palette, before);
  ByteReader reader(std::as_bytes(std::span(body)));
  const auto read = read_coded_palette(reader, before);
  EXPECT_TRUE(read.has_value());
  if (read) {
    EXPECT_EQ(read->levels, palette.levels);
  }
  EXPECT_TRUE(reader.empty());
  return body;
}

TEST(DisparityLaw, NamesNearlyEveryLevelOfAKinect) {
  const Levels levels = kinect_levels(1.0, 0.2, 1);
  const auto law = fit_disparity_law(levels);
  ASSERT_TRUE(law.has_value());
  std::size_t named = 0;
  for (const std::uint16_t level : levels) {
    const auto off = static_cast<int>(law->level_at(law->step_of(level))) - level;
    EXPECT_LE(std::abs(off), 1) << level;
    named += off == 0 ? 1 : 0;
  }
  EXPECT_GT(named, levels.size() * 9 / 10);
}

TEST(DisparityLaw, LevelsAtEqualDistancesHaveNone) {
  Levels even;
  for (int i = 1; i < 400; ++i) even.push_back(static_cast<std::uint16_t>(500 + 7 * i));
  const auto law = fit_disparity_law(even);
  if (!law) return;
  std::size_t named = 0;
  for (const std::uint16_t level : even) named += law->level_at(law->step_of(level)) == level ? 1 : 0;
  EXPECT_LT(named, even.size() / 2) << "two numbers cannot express these";
}

TEST(PaletteCoding, AKinectsLevelsTakeLessThanABitAndAHalfEach) {
  for (const double unit_mm : {1.0, 0.1}) {
    const Levels levels = kinect_levels(unit_mm, 0.1, 2);
    EXPECT_LT(coded(levels).size() * 8, levels.size() * 3 / 2 + 120) << unit_mm;
  }
}

TEST(PaletteCoding, AnyLevelsComeBackAsTheyWere) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    std::set<std::uint16_t> levels;
    const int count = std::uniform_int_distribution<>(0, 600)(random);
    const int most = 1 << std::uniform_int_distribution<>(1, 16)(random);
    for (int i = 0; i < count; ++i)
      levels.insert(static_cast<std::uint16_t>(std::uniform_int_distribution<>(1, most - 1)(random)));
    if (trial % 3 == 0)
      for (const std::uint16_t level : kinect_levels(trial % 2 ? 1.0 : 0.1, 0.3, static_cast<unsigned>(trial)))
        levels.insert(level);
    SCOPED_TRACE(trial);
    coded({levels.begin(), levels.end()});
    LevelPalette before;
    for (const std::uint16_t level : levels)
      if (random() % 4 != 0) before.levels.push_back(level);
    coded({levels.begin(), levels.end()}, before);
    if (HasFailure()) return;
  }
}

TEST(PaletteCoding, EveryLevelThereIsAndTheFarthestAlone) {
  Levels all(65535);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint16_t>(i + 1);
  coded(all);
  coded({65535});
  coded({1});
  coded({});
}

TEST(PaletteCoding, DamagedBytesGiveAPaletteInOrderOrNone) {
  std::mt19937 random(9);
  const std::string good = coded(kinect_levels(1.0, 0.1, 3));
  for (int trial = 0; trial < 20'000; ++trial) {
    std::string bad = good;
    bad[1 + random() % (bad.size() - 1)] = static_cast<char>(random());
    ByteReader reader(std::as_bytes(std::span(bad)));
    const auto read = read_coded_palette(reader, {});
    if (!read) continue;
    ASSERT_EQ(read->levels.front(), 0);
    ASSERT_TRUE(std::ranges::is_sorted(read->levels, std::ranges::less_equal{}));
  }
}

}  // namespace
}  // namespace telepalp::codec
