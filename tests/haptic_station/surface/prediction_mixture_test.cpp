#include "haptic_station/surface/temporal/prediction_mixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace telepalp::surface {
namespace {

constexpr double kFrame_s = 1.0 / 30.0;
constexpr std::size_t kCells = 12;

/// A body of which all cells move as `at_m(t)`. Its straight and its modelled prediction are exact if it goes on with
/// the speeds `straight(t)` and `modelled(t)`.
struct Body {
  std::function<double(double)> at_m;
  std::function<double(double)> straight_m_per_s;
  std::function<double(double)> modelled_m_per_s;
};

PredictionMixture judged(const Body& body, double until_s, const std::vector<float>& weight) {
  PredictionMixture mixture;
  for (double t = 0.0; t < until_s; t += kFrame_s) {
    FramePrediction now;
    now.displacement_m.assign(kCells, static_cast<float>(body.at_m(t)));
    MotionTerms terms{};
    terms[0] = static_cast<float>(body.modelled_m_per_s(t));
    terms[kStraightTerm] = static_cast<float>(body.straight_m_per_s(t));
    now.terms.assign(kCells, terms);
    now.model.moves = true;
    now.model.linear_fade_s = 1e3;
    mixture.add(now.displacement_m, weight, now, kFrame_s);
  }
  return mixture;
}

PredictionMixture judged(const Body& body, double until_s) {
  return judged(body, until_s, std::vector<float>(kCells, 1.0F));
}

double rest(const PredictionMixture& mixture, std::size_t age) {
  return 1.0 - mixture.straight()[age] - mixture.modelled()[age];
}

double still(double) { return 0.0; }
double even_m(double t) { return 0.03 * t; }
double even_m_per_s(double) { return 0.03; }

TEST(PredictionMixture, TrustsTheModelUntilErrorsAreKnown) {
  const PredictionMixture mixture;
  EXPECT_EQ(mixture.modelled(), kFullForesight);
  EXPECT_EQ(mixture.straight(), kNoForesight);
}

TEST(PredictionMixture, TheBestOfThePredictionsGetsTheWeight) {
  const PredictionMixture modelled = judged({even_m, still, even_m_per_s}, 12.0);
  const PredictionMixture straight = judged({even_m, even_m_per_s, still}, 12.0);
  const PredictionMixture held = judged({still, even_m_per_s, even_m_per_s}, 12.0);
  for (std::size_t age = 0; age < kForesightAges_s.size(); ++age) {
    EXPECT_GT(modelled.modelled()[age], 0.99);
    EXPECT_GT(straight.straight()[age], 0.95);
    EXPECT_GT(rest(held, age), 0.95);
  }
}

/// A model that is right for ten seconds, and then says that the body stays, while it moves on: within 0.3 s the
/// straight prediction leads, although the errors over ten seconds still speak for the model.
TEST(PredictionMixture, FollowsAShiftStraightOnWithinThreeTenthsOfASecond) {
  const auto modelled_m_per_s = [](double t) { return t < 10.0 ? 0.0 : -0.03; };
  const auto at_m = [](double t) { return t < 10.0 ? 0.0 : 0.06 * (t - 10.0); };
  const auto straight_m_per_s = [](double t) { return t < 10.0 ? 0.002 * std::sin(40.0 * t) : 0.06; };
  const PredictionMixture before = judged({at_m, straight_m_per_s, modelled_m_per_s}, 9.9);
  const PredictionMixture after = judged({at_m, straight_m_per_s, modelled_m_per_s}, 10.6);
  EXPECT_LT(before.straight()[0], 0.1);
  EXPECT_GT(after.straight()[0], 0.6);
}

/// Jerks of 6 mm that end as soon as a prediction knows them: after one, the speed says that the body goes on.
TEST(PredictionMixture, HoldsABodyWhoseMotionsEndBeforeTheyAreKnown) {
  const auto at_m = [](double t) { return static_cast<int>(std::floor(t)) % 2 == 0 ? 0.0 : 0.006; };
  const auto late_m_per_s = [](double t) {
    const double into_s = t - std::floor(t);
    return into_s > 0.1 ? 0.0 : (static_cast<int>(std::floor(t)) % 2 == 0 ? -0.1 : 0.1);
  };
  const PredictionMixture mixture = judged({at_m, late_m_per_s, late_m_per_s}, 15.05);
  EXPECT_GT(rest(mixture, 0), 0.9);
  EXPECT_GT(rest(mixture, 2), 0.9);
}

TEST(PredictionMixture, CellsWithoutWeightDoNotCount) {
  std::vector<float> weight(kCells, 0.0F);
  weight[3] = 1.0F;
  PredictionMixture mixture;
  for (double t = 0.0; t < 5.0; t += kFrame_s) {
    FramePrediction now;
    now.displacement_m.assign(kCells, 0.0F);
    now.displacement_m[3] = static_cast<float>(even_m(t));
    MotionTerms terms{};
    terms[0] = 0.03F;
    now.terms.assign(kCells, terms);
    now.model.moves = true;
    now.model.linear_fade_s = 1e3;
    mixture.add(now.displacement_m, weight, now, kFrame_s);
  }
  EXPECT_GT(mixture.modelled()[1], 0.99);
}

TEST(PredictionMixture, WeightsAreNeverNegativeAndTheirSumIsAtMostOne) {
  for (const double hold_m2 : {0.0, 1e-12, 1e-6, 1e-2})
    for (const double straight_m2 : {0.0, 1e-12, 1e-6, 1e-2})
      for (const double modelled_m2 : {0.0, 1e-12, 1e-6, 1e-2}) {
        const PredictionErrors errors{hold_m2, straight_m2, modelled_m2, 0.5 * hold_m2};
        const PredictionWeights mixed = mixture_of(errors);
        const PredictionWeights last = chosen(errors, mixed);
        for (const PredictionWeights& weights : {mixed, last}) {
          EXPECT_GE(weights.straight, 0.0);
          EXPECT_GE(weights.modelled, 0.0);
          EXPECT_LE(weights.straight + weights.modelled, 1.0 + 1e-12);
        }
      }
}

}  // namespace
}  // namespace telepalp::surface
