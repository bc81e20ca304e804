#include "haptic_station/surface/foresight/prediction_weights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptic_station/surface/foresight/past_predictions.h"
#include "haptic_station/surface/foresight/recent_mean.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::surface {
namespace {

PredictionWeights learned(const SquareErrors& errors, double for_s, PredictionWeights weights = {}) {
  for (double t = 0.0; t < for_s; t += kFrame_s) {
    weights.pass(kFrame_s);
    weights.add(errors, kFrame_s);
  }
  return weights;
}

/// Source: Bates and Granger 1969, for independent errors.
TEST(PredictionWeights, ThePowerOneGivesTheMeanWithTheLeastVariance) {
  const OfThree weight = inverse_power_weights({1e-6, 2e-6, 4e-6}, 1.0);
  EXPECT_NEAR(weight[0], 4.0 / 7.0, 1e-12);
  EXPECT_NEAR(weight[1], 2.0 / 7.0, 1e-12);
  EXPECT_NEAR(weight[2], 1.0 / 7.0, 1e-12);
}

TEST(PredictionWeights, AHighPowerAlmostChoosesTheBestAndStaysFinite) {
  const OfThree weight = inverse_power_weights({1e-30, 1.5e-30, 1.0}, 16.0);
  EXPECT_GT(weight[0], 0.99);
  EXPECT_LT(weight[1], 0.01);
  EXPECT_EQ(weight[2], 0.0);
}

TEST(PredictionWeights, BeforeAnyErrorIsKnownTheStationsOwnPredictionCounts) {
  EXPECT_GT(PredictionWeights().weights()[0], 0.99);
}

TEST(PredictionWeights, AShiftIsFollowedStraightWithinThreeTenthsOfASecond) {
  const SquareErrors breath{.own = 1e-8, .holding = 4e-7, .straight = 1e-7, .mean = 8e-9, .swing = 4e-7};
  const SquareErrors shift{.own = 2e-6, .holding = 9e-6, .straight = 1e-7, .mean = 4e-7, .swing = 9e-6};
  const PredictionWeights weights = learned(shift, 0.3, learned(breath, 10.0));
  EXPECT_GT(weights.short_term()[2], 0.9);
  EXPECT_GT(weights.weights()[2], 0.8);
}

TEST(PredictionWeights, APatientWhoCoughsIsHeldEvenWhileAnotherPredictionIsRight) {
  const SquareErrors cough{.own = 4e-6, .holding = 2e-6, .straight = 5e-6, .mean = 3e-6, .swing = 3e-6};
  const SquareErrors for_a_moment{.own = 4e-6, .holding = 2e-6, .straight = 1e-8, .mean = 1e-8, .swing = 3e-6};
  const PredictionWeights weights = learned(for_a_moment, 1.0, learned(cough, 10.0));
  EXPECT_GT(weights.short_term()[2], 0.9) << "the short time scale alone would follow";
  EXPECT_GT(weights.weights()[1], 0.95);
}

/// One cell that moves by `velocity_m_per_s`; its own prediction says that it rests, its straight one says the truth.
PastPredictions watched(double velocity_m_per_s, double until_s, double gap_from_s = 1e9) {
  PastPredictions past;
  MotionModel model;
  model.moves = true;
  model.breathing_rad_per_s = 3.0;
  model.linear_fade_s = 1e3;
  MotionTerms terms{};
  terms[kStraightTerm] = static_cast<float>(velocity_m_per_s);
  const std::vector<float> counts{1.0F};
  double last_s = 0.0;
  for (int n = 0; n * kFrame_s < until_s; ++n) {
    const double t = n * kFrame_s;
    if (t > gap_from_s && t < gap_from_s + 0.5) continue;
    const std::vector<float> at_m{static_cast<float>(velocity_m_per_s * t)};
    past.judge(at_m, counts, t - last_s);
    past.remember(at_m, std::vector<MotionTerms>{terms}, model);
    last_s = t;
  }
  return past;
}

TEST(PredictionWeights, TheSwingCountsOnlyIfItErrsFarLess) {
  const SquareErrors talk{.own = 4e-6, .holding = 4e-6, .straight = 4e-6, .mean = 4e-6, .swing = 5e-7};
  EXPECT_GT(learned(talk, 10.0).weights()[3], 0.95);
  const SquareErrors cough{.own = 4e-6, .holding = 4e-6, .straight = 4e-6, .mean = 4e-6, .swing = 1e-6};
  EXPECT_LT(learned(cough, 10.0).weights()[3], 0.05);
}

TEST(PastPredictions, TheStraightPredictionOfABodyThatGoesStraightGetsAllTheWeight) {
  const PastPredictions past = watched(0.02, 3.0);
  for (const double weight : past.straight()) EXPECT_GT(weight, 0.9);
  for (const double weight : past.own()) EXPECT_LT(weight, 0.05);
}

/// The share of the way to the mean place after 20 s of one cell that swings at 1.7 Hz.
ForesightShare to_mean_of_swing(double amplitude_m) {
  PastPredictions past;
  RecentMean mean(1);
  MotionModel model;
  model.moves = true;
  model.breathing_rad_per_s = 3.0;
  MotionTerms terms{};
  const std::vector<float> counts{1.0F};
  constexpr double kRate_rad_per_s = 2.0 * 3.14159 * 1.7;
  for (int n = 0; n < 600; ++n) {
    const double phase = kRate_rad_per_s * n * kFrame_s;
    const std::vector<float> at_m{static_cast<float>(0.01 + amplitude_m * std::sin(phase))};
    terms[kStraightTerm] = static_cast<float>(amplitude_m * kRate_rad_per_s * std::cos(phase));
    past.judge(at_m, counts, kFrame_s);
    mean.add(at_m, kFrame_s);
    terms[kMeanTerm] = static_cast<float>(mean.m(0)) - at_m[0];
    past.remember(at_m, std::vector<MotionTerms>{terms}, model);
  }
  EXPECT_NEAR(mean.m(0), 0.01, 0.1 * amplitude_m);
  return past.to_mean();
}

/// After 0.12 s, a cell that swings fast may be anywhere in its swing, so its mean place is the best guess.
TEST(PastPredictions, ACellThatSwingsFastIsSentBackToItsMeanPlace) {
  const ForesightShare share = to_mean_of_swing(0.003);
  EXPECT_LT(share[0], share[1]) << "the younger the image, the more it says about now";
  EXPECT_GT(share[1], 0.6);
  EXPECT_GT(share[2], 1.0) << "beyond the mean after a third of a swing";
}

TEST(PastPredictions, ACellThatGoesFartherThanASyllableIsNotSentBack) {
  for (const double share : to_mean_of_swing(0.03)) EXPECT_LT(share, 0.05);
}

TEST(PastPredictions, ACellThatKeepsItsPlaceAfterAShiftIsNotSentBack) {
  PastPredictions past;
  RecentMean mean(1);
  MotionModel model;
  model.moves = true;
  MotionTerms terms{};
  const std::vector<float> counts{1.0F};
  for (int n = 0; n < 300; ++n) {
    const std::vector<float> at_m{n / 90 % 2 == 0 ? 0.0F : 0.01F};
    past.judge(at_m, counts, kFrame_s);
    mean.add(at_m, kFrame_s);
    terms[kMeanTerm] = static_cast<float>(mean.m(0)) - at_m[0];
    past.remember(at_m, std::vector<MotionTerms>{terms}, model);
  }
  for (const double share : past.to_mean()) EXPECT_LT(share, 0.05);
}

TEST(PastPredictions, AFrameAfterAGapDoesNotJudgePredictionsThatWereMadeForAnEarlierInstant) {
  const PastPredictions before = watched(0.02, 0.05);
  const PastPredictions after = watched(0.02, 0.58, 0.05);
  EXPECT_EQ(before.own(), after.own());
}

}  // namespace
}  // namespace telepalp::surface
