#include "support/plot/scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/plot/histogram.h"
#include "support/plot/number.h"

namespace telepalp::plot {
namespace {

TEST(Number, HasNoTrailingZerosAndNoNegativeZero) {
  EXPECT_EQ(number(1.50), "1.5");
  EXPECT_EQ(number(2.0), "2");
  EXPECT_EQ(number(-0.001), "0");
  EXPECT_EQ(number(1e300).size(), 301U);
}

TEST(Number, NeverPrintsNan) {
  EXPECT_EQ(number(std::nan("")), "–");
  EXPECT_EQ(readable(std::numeric_limits<double>::infinity()), "–");
}

TEST(Number, KeepsAboutThreeSignificantDigitsForPeople) {
  EXPECT_EQ(readable(0.012345), "0.0123");
  EXPECT_EQ(readable(1.2345), "1.23");
  EXPECT_EQ(readable(1234.5), "1234");
}

TEST(Ticks, StandAtOneTwoOrFiveTimesAPowerOfTen) {
  const auto ticks = nice_ticks({0.0, 10.0}, 5);
  ASSERT_EQ(ticks.size(), 6U);
  EXPECT_EQ(ticks[1].label, "2");
  EXPECT_EQ(nice_ticks({0.0, 0.05}, 5)[1].label, "0.01");
}

TEST(Ticks, LieWithinTheRangeAndAscendForAnyRange) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> start(-1e3, 1e3), magnitude(-9.0, 6.0);
  for (int i = 0; i < 2000; ++i) {
    const double least = start(random), most = least + std::pow(10.0, magnitude(random));
    const auto ticks = nice_ticks({least, most}, 6);
    ASSERT_LE(ticks.size(), 16U) << least << " … " << most;
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      ASSERT_GE(ticks[k].at, least);
      ASSERT_LE(ticks[k].at, most);
      if (k > 0) {
        ASSERT_GT(ticks[k].at, ticks[k - 1].at);
      }
    }
  }
}

TEST(Ticks, AreAbsentForAnEmptyRange) {
  EXPECT_TRUE(nice_ticks({1.0, 1.0}, 5).empty());
  EXPECT_TRUE(nice_ticks({0.0, std::nan("")}, 5).empty());
  EXPECT_TRUE(decade_ticks({0.0, 10.0}).empty());
}

TEST(Scale, MapsEndsToEndsLinearlyAndByLogarithm) {
  const Scale linear{{0.0, 10.0}, {100.0, 0.0}};
  EXPECT_DOUBLE_EQ(linear(0.0), 100.0);
  EXPECT_DOUBLE_EQ(linear(10.0), 0.0);
  const Scale decades{{1.0, 100.0}, {0.0, 200.0}, true};
  EXPECT_NEAR(decades(10.0), 100.0, 1e-9);
  EXPECT_TRUE(std::isnan(decades(0.0)));
}

TEST(Histogram, CountsEveryFiniteValueOnce) {
  const std::vector<double> values{1.0, 2.0, 3.0, 0.0, -1.0, 950.0, std::nan(""), 1e300};
  const Histogram histogram = logarithmic_histogram(values, 10);
  double total = 0.0;
  for (const double count : histogram.counts) total += count;
  EXPECT_EQ(total, 7.0);
  EXPECT_EQ(histogram.edges.size(), histogram.counts.size() + 1);
  EXPECT_LT(histogram.counts.size(), 200U);
}

TEST(Histogram, IsEmptyWithoutValues) {
  EXPECT_TRUE(logarithmic_histogram({}, 10).counts.empty());
  const std::vector<double> none{std::nan("")};
  EXPECT_TRUE(logarithmic_histogram(none, 10).counts.empty());
}

}  // namespace
}  // namespace telepalp::plot
