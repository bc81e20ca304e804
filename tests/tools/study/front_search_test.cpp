#include "tools/study/search/front_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace telepalp::study {
namespace {

/// Two paraboloids: the objective is least at (0.8, 0.3), `bounded` at (0.2, 0.3). The front between them is the line
/// y = 0.3, on which sqrt(objective) + sqrt(bounded) = 0.6.
std::optional<Score> paraboloids(const std::vector<double>& at) {
  const auto squared = [&](double x) { return std::pow(at[0] - x, 2) + std::pow(at[1] - 0.3, 2); };
  return Score{squared(0.8), squared(0.2)};
}

std::vector<std::optional<Score>> scores_of(const std::vector<ScoredPoint>& points) {
  std::vector<std::optional<Score>> scores;
  for (const ScoredPoint& one : points) scores.push_back(one.score);
  return scores;
}

FrontSettings two_dimensions() {
  return {.dimensions = 2, .evaluations = 400, .bounds = 3, .seed = 1, .starts = {{0.5, 0.9}}};
}

TEST(FrontSearch, FindsBothOptimaAndTheLeastObjectiveUnderEachBoundOfAKnownFront) {
  const std::vector<ScoredPoint> points = search_front(two_dimensions(), paraboloids, {});
  EXPECT_LE(points.size(), 400U);
  const auto scores = scores_of(points);
  const std::vector<std::size_t> front = front_of(scores, 3);
  ASSERT_EQ(front.size(), 5U);
  EXPECT_LT(scores[front.front()]->bounded, 1e-3);
  EXPECT_LT(scores[front.back()]->objective, 1e-3);
  const std::vector<double> bounds = bounds_between_optima(scores, 3);
  for (std::size_t i = 1; i + 1 < front.size(); ++i) {
    const double known = std::pow(0.6 - std::sqrt(bounds[i]), 2);
    EXPECT_NEAR(scores[front[i]]->objective, known, 0.015) << "under the bound " << bounds[i];
    EXPECT_LE(scores[front[i]]->bounded, bounds[i] * (1.0 + 1e-9));
  }
}

TEST(FrontSearch, TheFrontIsMonotoneAndNoScoredPointBeatsAMember) {
  const auto scores = scores_of(search_front(two_dimensions(), paraboloids, {}));
  const std::vector<std::size_t> front = front_of(scores, 3);
  for (std::size_t i = 0; i < front.size(); ++i) {
    const Score& member = *scores[front[i]];
    if (i > 0) {
      EXPECT_GT(member.bounded, scores[front[i - 1]]->bounded);
      EXPECT_LT(member.objective, scores[front[i - 1]]->objective);
    }
    for (const std::optional<Score>& other : scores)
      EXPECT_FALSE(other->objective <= member.objective && other->bounded <= member.bounded &&
                   (other->objective < member.objective || other->bounded < member.bounded));
  }
}

TEST(FrontSearch, InfeasiblePointsAreNoValuesAndTheSearchGoesAroundThem) {
  // Around the free optimum (0.8, 0.3), points within 0.2 are refused: the best feasible value is 0.2 squared.
  const auto holed = [](const std::vector<double>& at) -> std::optional<Score> {
    const Score score = *paraboloids(at);
    if (score.objective < 0.04) return std::nullopt;
    return score;
  };
  const auto scores = scores_of(search_front(two_dimensions(), holed, {}));
  const std::vector<std::size_t> front = front_of(scores, 3);
  ASSERT_FALSE(front.empty());
  EXPECT_NEAR(scores[front.back()]->objective, 0.04, 0.01);
}

TEST(FrontSearch, WhereNothingIsFeasibleTheFrontIsEmptyAndTheSearchEnds) {
  const auto points =
      search_front(two_dimensions(), [](const std::vector<double>&) -> std::optional<Score> { return {}; }, {});
  EXPECT_TRUE(front_of(scores_of(points), 3).empty());
  EXPECT_TRUE(bounds_between_optima(scores_of(points), 3).empty());
}

TEST(FrontSearch, AsksForNoPointTwiceAndNeverForMoreThanAllowedAndIsTheSameTwice) {
  FrontSettings settings = two_dimensions();
  settings.evaluations = 60;
  const auto one = search_front(settings, paraboloids, {});
  const auto other = search_front(settings, paraboloids, {});
  ASSERT_LE(one.size(), 60U);
  ASSERT_EQ(one.size(), other.size());
  std::vector<std::vector<double>> places;
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].at, other[i].at);
    for (const double share : one[i].at) EXPECT_TRUE(share >= 0.0 && share <= 1.0);
    places.push_back(one[i].at);
  }
  std::sort(places.begin(), places.end());
  EXPECT_EQ(std::adjacent_find(places.begin(), places.end()), places.end());
}

TEST(FrontSearch, AStopEndsItAfterThePointThatIsBeingScored) {
  std::stop_source stop;
  int scored = 0;
  const auto points = search_front(
      two_dimensions(),
      [&](const std::vector<double>& at) {
        if (++scored == 30) stop.request_stop();
        return paraboloids(at);
      },
      stop.get_token());
  EXPECT_EQ(points.size(), 30U);
}

TEST(Front, OfEqualScoresTheFirstIsTakenAndDominatedOnesAreLeftOut) {
  const std::vector<std::optional<Score>> scores{Score{3.0, 1.0}, std::nullopt,    Score{3.0, 1.0},
                                                 Score{1.0, 3.0}, Score{2.0, 4.0}, Score{2.0, 2.0}};
  EXPECT_EQ(non_dominated(scores), (std::vector<std::size_t>{0, 5, 3}));
  EXPECT_EQ(bounds_between_optima(scores, 1), (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(front_of(scores, 1), (std::vector<std::size_t>{0, 5, 3}));
}

TEST(Front, OneScoreThatIsBestInBothIsTheWholeFront) {
  const std::vector<std::optional<Score>> scores{Score{2.0, 2.0}, Score{1.0, 1.0}};
  EXPECT_EQ(front_of(scores, 5), (std::vector<std::size_t>{1}));
}

}  // namespace
}  // namespace telepalp::study
