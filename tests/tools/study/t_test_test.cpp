#include "tools/study/figures/t_test.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "haptic_station/device/random.h"

namespace telepalp::study {
namespace {

TEST(Welch, GivesWhatThePaperPrintsFromItsPrintedMeans) {
  // S3 8.3: printed t = 3.49 and 1.82. Its rounded means and deviations give 3.40 and 1.83.
  const TTest green = welch_test({10.34, 3.57, 15}, {6.96, 1.43, 15});
  EXPECT_NEAR(green.t, 3.40, 0.005);
  EXPECT_NEAR(green.degrees, 18.4, 0.05);
  EXPECT_NEAR(green.p, 0.003, 0.0005);
  const TTest blue = welch_test({8.68, 3.3, 15}, {6.94, 1.65, 15});
  EXPECT_NEAR(blue.t, 1.83, 0.005);
  EXPECT_NEAR(blue.degrees, 20.6, 0.05);
  EXPECT_GT(blue.p, 0.05);
  EXPECT_LT(blue.low, 0.0);
}

TEST(Paired, AgreesWithAWorkedExample) {
  // Differences 1, 2, 3, 4, 5: mean 3, SD 1.5811, t = 4.2426 with 4 degrees, p = 0.01324.
  const TTest test = paired_test(std::array{2.0, 4.0, 6.0, 8.0, 10.0}, std::array{1.0, 2.0, 3.0, 4.0, 5.0});
  EXPECT_NEAR(test.t, 4.2426, 1e-4);
  EXPECT_NEAR(test.p, 0.01324, 1e-5);
  EXPECT_NEAR(test.effect, 3.0 / 1.58114, 1e-4);
  EXPECT_NEAR(test.high - test.low, 2.0 * 2.77645 * 0.707107, 1e-4);
}

TEST(TTest, WithoutADifferenceOneInTwentyIsSignificant) {
  device::Random random(3);
  int welch = 0, paired = 0;
  constexpr int kTests = 2000;
  for (int i = 0; i < kTests; ++i) {
    std::vector<double> first(10), second(10);
    for (double& value : first) value = random.normal();
    for (double& value : second) value = 3.0 * random.normal();
    welch += welch_test(sample_of(first), sample_of(second)).p < 0.05 ? 1 : 0;
    paired += paired_test(first, second).p < 0.05 ? 1 : 0;
  }
  EXPECT_NEAR(welch, 0.05 * kTests, 35);
  EXPECT_NEAR(paired, 0.05 * kTests, 35);
}

TEST(Power, IsTheShareOfStudiesThatFindTheEffect) {
  // Cohen 1988: 64 people in each group find d = 0.5 with a power of 0.8; 34 do within subjects.
  EXPECT_NEAR(people_for_power(0.5, false), 64, 1);
  EXPECT_NEAR(people_for_power(0.5, true), 34, 1);
  device::Random random(4);
  constexpr int kStudies = 2000;
  int found = 0;
  for (int i = 0; i < kStudies; ++i) {
    std::vector<double> first(20), second(20);
    for (double& value : first) value = random.normal() + 0.8;
    for (double& value : second) value = random.normal();
    found += welch_test(sample_of(first), sample_of(second)).p < 0.05 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(found) / kStudies, welch_test({0.8, 1.0, 20}, {0.0, 1.0, 20}).power, 0.03);
}

TEST(TTest, WithoutAnySpreadPIsOneOrZeroAndNothingIsNotANumber) {
  EXPECT_EQ(paired_test(std::array{1.0, 2.0}, std::array{1.0, 2.0}).p, 1.0);
  EXPECT_EQ(welch_test({2.0, 0.0, 5}, {1.0, 0.0, 5}).p, 0.0);
  EXPECT_EQ(people_for_power(0.0, true), 10'000);
}

}  // namespace
}  // namespace telepalp::study
