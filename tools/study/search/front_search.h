#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace telepalp::study {

/// Two values of one point, both to be small.
struct Score {
  double objective = 0.0;  ///< least first: the overshoot
  double bounded = 0.0;    ///< what the front bounds: the force on the hand
};

/// A point of the unit cube, and its score. nullopt: the point is infeasible, which is never a value.
struct ScoredPoint {
  std::vector<double> at;
  std::optional<Score> score;
};

struct FrontSettings {
  std::size_t dimensions = 1;
  int evaluations = 300;  ///< most calls of the scoring, those at `starts` included
  int bounds = 5;         ///< on Score::bounded, between the two single optima
  std::uint64_t seed = 1;
  std::vector<std::vector<double>> starts;  ///< scored first
};

/// Called once for each point, in an order that depends on the settings and the scores alone.
using Scoring = std::function<std::optional<Score>(const std::vector<double>& at)>;

/// Scores points of the unit cube, in search of the least objective, of the least `bounded`, and of the least objective
/// under each of several upper bounds on `bounded` (the epsilon-constraint method: Haimes, Lasdon, Wismer 1971).
/// Returns all points in the order in which they were scored. Pure but for `score`; uses NLopt.
[[nodiscard]] std::vector<ScoredPoint> search_front(const FrontSettings& settings, const Scoring& score,
                                                    const std::stop_token& stop);

/// Indices of the feasible scores that no other one beats. A score beats another one if it is as good in both values
/// and better in one. From the least
/// `bounded` to the least objective; of equal scores, the first.
[[nodiscard]] std::vector<std::size_t> non_dominated(std::span<const std::optional<Score>> scores);

/// Evenly spaced bounds from the least `bounded` of any feasible score to that of the score with the least objective,
/// both included; empty if no score is feasible, one if both are the same score.
[[nodiscard]] std::vector<double> bounds_between_optima(std::span<const std::optional<Score>> scores, int between);

/// The members of non_dominated() that have the least objective under some bound of bounds_between_optima(): at most
/// `between` + 2 of them.
[[nodiscard]] std::vector<std::size_t> front_of(std::span<const std::optional<Score>> scores, int between);

}  // namespace telepalp::study
