#include "tools/study/figures/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptic_station/device/random.h"
#include "tools/study/figures/paper_table.h"

namespace telepalp::study {
namespace {

TEST(RankCorrelation, IsOneForTheSameOrderAndSharesRanksOfEqualValues) {
  EXPECT_DOUBLE_EQ(rank_correlation(std::vector{1.0, 5.0, 7.0}, std::vector{-3.0, 0.0, 100.0}), 1.0);
  EXPECT_DOUBLE_EQ(rank_correlation(std::vector{1.0, 5.0, 7.0}, std::vector{9.0, 8.0, 7.0}), -1.0);
  // ranks 0, 1.5, 1.5, 3 against 0, 1, 2, 3
  EXPECT_NEAR(rank_correlation(std::vector{1.0, 2.0, 2.0, 3.0}, std::vector{1.0, 2.0, 3.0, 4.0}),
              4.5 / std::sqrt(4.5 * 5.0), 1e-12);
  EXPECT_EQ(rank_correlation(std::vector{2.0, 2.0}, std::vector{1.0, 2.0}), 0.0);
}

TEST(Bootstrap, HoldsTheMeanInAboutNineteenOfTwentySamples) {
  device::Random random(5);
  int holds = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<double> values(20);
    for (double& value : values) value = 3.0 + random.normal();
    const Interval interval = bootstrap(values, 7);
    holds += interval.low <= 3.0 && 3.0 <= interval.high ? 1 : 0;
  }
  EXPECT_GT(holds, 265);
  EXPECT_LT(holds, 299);
}

/// Noise of 1 mm, operators that differ by 3 mm, and what `add` returns for a configuration's linkage, phi, h, l_h.
template <class Add>
Factorial made_of(std::uint64_t seed, const Add& add) {
  device::Random random(seed);
  Factorial values(8, std::vector<double>(36));
  for (auto& person : values) {
    const double own = 3.0 * random.normal();
    for (int i = 0; i < 36; ++i)
      person[static_cast<std::size_t>(i)] = 10.0 + own + random.normal() + add(i / 12, i / 4 % 3, i / 2 % 2, i % 2);
  }
  return values;
}

const Effect& effect(const std::vector<Effect>& effects, const std::string& name) {
  for (const Effect& one : effects)
    if (one.name() == name) return one;
  ADD_FAILURE() << name;
  return effects.front();
}

TEST(Effects, FindsWhatIsThereAndNothingElse) {
  const auto effects =
      effects_of(made_of(11, [](int, int phi, int h, int) { return phi == 2 && h == 1 ? 3.0 : 0.0; }), 300, 1);
  ASSERT_EQ(effects.size(), 10U);
  EXPECT_LT(effect(effects, "phi x h").p, 0.01);
  EXPECT_LT(effect(effects, "phi").p, 0.01);
  EXPECT_LT(effect(effects, "h").p, 0.01);
  EXPECT_GT(effect(effects, "linkage x l_h").p, 0.02);
  EXPECT_NEAR(effect(effects, "h").means[1] - effect(effects, "h").means[0], 1.0, 0.5);
}

TEST(Effects, WithoutAnEffectSmallPAreAsRareAsTheySay) {
  int small = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
    for (const Effect& one : effects_of(made_of(seed, [](int, int, int, int) { return 0.0; }), 100, seed))
      small += one.p < 0.05 ? 1 : 0;
  EXPECT_LT(small, 16) << "of 120 tests; 6 are expected";
}

TEST(PaperTable, ShowsThePatternsThatThePaperReadsFromIt) {
  const std::vector<Pattern> patterns = patterns_of(paper_overshoots_mm());
  ASSERT_EQ(patterns.size(), 6U);
  for (const Pattern& one : patterns) EXPECT_TRUE(one.holds) << one.what;
  EXPECT_EQ(patterns[3].in_paper, "14 of 18") << "S4 6.3 counts these pairs";
}

TEST(PaperTable, APatternIsCertainOnlyIfItHoldsInAlmostAllResamplesOfTheOperators) {
  Factorial agreeing(6, paper_overshoots_mm());
  for (const Pattern& one : patterns_of(agreeing, 1)) EXPECT_EQ(verdict(one), "appears");
  device::Random random(3);
  Factorial noise(6, std::vector<double>(36));
  for (auto& person : noise)
    for (double& value : person) value = random.normal();
  int certain = 0;
  for (const Pattern& one : patterns_of(noise, 1)) certain += verdict(one) == "appears" ? 1 : 0;
  EXPECT_LE(certain, 1);
}

TEST(PaperTable, NoiseCeilingDependsOnWhatTheDeviationIsOver) {
  EXPECT_NEAR(noise_ceiling(20.0, 1), 0.90, 0.03);
  EXPECT_NEAR(noise_ceiling(4.0, 1), 0.50, 0.05);
}

}  // namespace
}  // namespace telepalp::study
