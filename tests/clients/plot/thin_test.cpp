#include "support/plot/thin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace telepalp::plot {
namespace {

struct Curve {
  std::vector<double> x, y;
};

Curve noisy_curve(std::size_t samples, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise;
  Curve curve;
  for (std::size_t i = 0; i < samples; ++i) {
    curve.x.push_back(static_cast<double>(i) / 2000.0);
    curve.y.push_back(noise(random));
  }
  return curve;
}

TEST(ThinKeepingExtremes, KeepsEveryColumnsLeastAndGreatest) {
  constexpr std::size_t kColumns = 100;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Curve curve = noisy_curve(20'000, seed);
    const auto kept = thin_keeping_extremes(curve.x, curve.y, kColumns);
    EXPECT_LE(kept.size(), 4 * (kColumns + 1)) << "seed " << seed;
    double least = 1e9, greatest = -1e9;
    for (const std::size_t i : kept) {
      least = std::min(least, curve.y[i]);
      greatest = std::max(greatest, curve.y[i]);
    }
    EXPECT_EQ(least, *std::min_element(curve.y.begin(), curve.y.end())) << "seed " << seed;
    EXPECT_EQ(greatest, *std::max_element(curve.y.begin(), curve.y.end())) << "seed " << seed;
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end())) << "seed " << seed;
    EXPECT_EQ(kept.front(), 0U);
    EXPECT_EQ(kept.back(), curve.x.size() - 1);
  }
}

TEST(ThinKeepingExtremes, ASpikeOfOneSampleAmongAMillionSurvives) {
  Curve curve;
  for (std::size_t i = 0; i < 1'000'000; ++i) {
    curve.x.push_back(static_cast<double>(i));
    curve.y.push_back(0.0);
  }
  curve.y[617'283] = 42.0;
  const auto kept = thin_keeping_extremes(curve.x, curve.y, 800);
  EXPECT_NE(std::find(kept.begin(), kept.end(), 617'283U), kept.end());
}

TEST(ThinKeepingExtremes, AGapStaysAGap) {
  const std::vector<double> x{0, 1, 2, 3, 4};
  const std::vector<double> y{0, 1, std::nan(""), std::nan(""), 1};
  const auto kept = thin_keeping_extremes(x, y, 10);
  EXPECT_EQ(kept, (std::vector<std::size_t>{0, 1, 2, 4}));
}

TEST(ThinKeepingExtremes, NothingGivesNothing) { EXPECT_TRUE(thin_keeping_extremes({}, {}, 10).empty()); }

TEST(ThinPath, DropsOnlyWhatLiesNextToAKeptSample) {
  Curve walk = noisy_curve(5000, 3);
  for (std::size_t i = 1; i < walk.x.size(); ++i) {
    walk.x[i] = walk.x[i - 1] + 0.1 * walk.y[i];
    walk.y[i] = walk.y[i - 1] + 0.1 * std::sin(static_cast<double>(i));
  }
  const auto kept = thin_path(walk.x, walk.y, 0.5);
  EXPECT_LT(kept.size(), walk.x.size() / 2);
  std::size_t k = 0;
  for (std::size_t i = 0; i < walk.x.size(); ++i) {
    if (k + 1 < kept.size() && kept[k + 1] <= i) ++k;
    EXPECT_LT(std::hypot(walk.x[i] - walk.x[kept[k]], walk.y[i] - walk.y[kept[k]]), 0.5 + 1e-12);
  }
}

TEST(ThinPath, AGapStaysAGap) {
  const std::vector<double> x{0, 0, std::nan(""), std::nan(""), 0};
  const std::vector<double> y{0, 0, 0, 0, 0};
  EXPECT_EQ(thin_path(x, y, 1.0), (std::vector<std::size_t>{0, 2, 4}));
}

}  // namespace
}  // namespace telepalp::plot
