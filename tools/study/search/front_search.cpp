#include "tools/study/search/front_search.h"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

namespace telepalp::study {
namespace {

constexpr double kWithin = 1.0 + 1e-9;  // a score on a bound is within it
constexpr double kFirstStep = 0.2;      // of the unit cube: how far the first round of local searches looks
constexpr double kSameStep = 0.003;     // of the unit cube: mechanisms nearer than this are not told apart
constexpr double kShareOfGlobal = 0.4;  // of the evaluations that the starts leave
constexpr int kPopulationPerDimension = 4;
constexpr double kNoBound = std::numeric_limits<double>::infinity();

struct FreeOptimiser {
  void operator()(nlopt_opt optimiser) const noexcept { nlopt_destroy(optimiser); }
};
using Optimiser = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, FreeOptimiser>;

/// All scored points. A point that is asked for again is not scored again.
class Archive {
 public:
  Archive(const FrontSettings& settings, const Scoring& score, const std::stop_token& stop)
      : settings_(settings), score_(score), stop_(stop) {}

  /// No further point may be scored.
  [[nodiscard]] bool exhausted() const { return left() <= 0 || stop_.stop_requested(); }
  [[nodiscard]] int left() const { return settings_.evaluations - static_cast<int>(points_.size()); }
  [[nodiscard]] const std::optional<Score>& at(const std::vector<double>& at) {
    const auto [found, is_new] = index_.try_emplace(at, points_.size());
    if (is_new) {
      points_.push_back({at, score_(at)});
      scores_.push_back(points_.back().score);
    }
    return scores_[found->second];
  }
  [[nodiscard]] bool knows(const std::vector<double>& at) const { return index_.contains(at); }
  [[nodiscard]] std::span<const std::optional<Score>> scores() const { return scores_; }
  [[nodiscard]] const ScoredPoint& point(std::size_t index) const { return points_[index]; }
  [[nodiscard]] std::vector<ScoredPoint> take() && { return std::move(points_); }

 private:
  const FrontSettings& settings_;
  const Scoring& score_;
  const std::stop_token& stop_;
  std::vector<ScoredPoint> points_;
  std::vector<std::optional<Score>> scores_;
  std::map<std::vector<double>, std::size_t> index_;
};

double objective_of(const Score& score) noexcept { return score.objective; }
double bounded_of(const Score& score) noexcept { return score.bounded; }

/// One run of NLopt over the archive: which value is to be small, and the bound on the other one.
struct Run {
  Archive& archive;
  double (*value)(const Score&) noexcept;
  double bound = kNoBound;  // on Score::bounded
  int last_left = 0;        // the run ends when the archive has no more evaluations left than this
  double refused = 1.0;     // value of an infeasible point: worse than every feasible one so far, and finite
  double exceeded = 1.0;    // by how much an infeasible point misses the bound
  nlopt_opt optimiser = nullptr;

  const std::optional<Score>* score(unsigned dimensions, const double* at) {
    const std::vector<double> point(at, at + dimensions);
    if (!archive.knows(point) && (archive.exhausted() || archive.left() <= last_left)) {
      nlopt_force_stop(optimiser);
      return nullptr;
    }
    return &archive.at(point);
  }
};

double value_at(unsigned dimensions, const double* at, double* /*gradient*/, void* data) {
  Run& run = *static_cast<Run*>(data);
  const std::optional<Score>* score = run.score(dimensions, at);
  return score == nullptr || !*score ? run.refused : run.value(**score);
}

/// At most 0 where the bound holds, as NLopt asks of a constraint.
double excess_at(unsigned dimensions, const double* at, double* /*gradient*/, void* data) {
  Run& run = *static_cast<Run*>(data);
  const std::optional<Score>* score = run.score(dimensions, at);
  return score == nullptr || !*score ? run.exceeded : (*score)->bounded - run.bound;
}

void measure_penalties(Run& run) {
  double worst = 0.0;
  double furthest = 0.0;
  for (const std::optional<Score>& score : run.archive.scores()) {
    if (!score) continue;
    worst = std::max(worst, run.value(*score));
    furthest = std::max(furthest, score->bounded);
  }
  run.refused = std::max(1.0, 2.0 * worst);
  run.exceeded = std::isfinite(run.bound) ? std::max(1e-6, furthest - run.bound) : 0.0;
}

/// Runs `algorithm` from `from` for at most `evaluations` new points.
void optimise(Run run, nlopt_algorithm algorithm, const std::vector<double>& from, double step, int evaluations,
              unsigned population = 0) {
  const auto dimensions = static_cast<unsigned>(from.size());
  const Optimiser optimiser(nlopt_create(algorithm, dimensions));
  run.optimiser = optimiser.get();
  run.last_left = run.archive.left() - evaluations;
  measure_penalties(run);
  nlopt_set_lower_bounds1(run.optimiser, 0.0);
  nlopt_set_upper_bounds1(run.optimiser, 1.0);
  nlopt_set_initial_step1(run.optimiser, step);
  nlopt_set_xtol_abs1(run.optimiser, kSameStep);
  nlopt_set_maxeval(run.optimiser, 100 * std::max(1, evaluations));  // against a run that only asks for known points
  if (population > 0) nlopt_set_population(run.optimiser, population);
  nlopt_set_min_objective(run.optimiser, value_at, &run);
  if (std::isfinite(run.bound)) nlopt_add_inequality_constraint(run.optimiser, excess_at, &run, 1e-9);
  std::vector<double> at = from;
  double least = 0.0;
  // The archive holds what was found; how the run ended does not matter.
  (void)nlopt_optimize(run.optimiser, at.data(), &least);
}

/// The best feasible point for `value` within `bound`. nullopt: there is none.
std::optional<std::size_t> best_within(std::span<const std::optional<Score>> scores,
                                       double (*value)(const Score&) noexcept, double bound) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < scores.size(); ++i)
    if (scores[i] && scores[i]->bounded <= bound * kWithin && (!best || value(*scores[i]) < value(*scores[*best])))
      best = i;
  return best;
}

void search_locally(Archive& archive, double (*value)(const Score&) noexcept, double bound, double step,
                    int evaluations) {
  const std::optional<std::size_t> best = best_within(archive.scores(), value, bound);
  if (!best || evaluations <= 0) return;
  const std::vector<double> from = archive.point(*best).at;
  optimise({.archive = archive, .value = value, .bound = bound}, NLOPT_LN_COBYLA, from, step, evaluations);
}

/// One round: both single optima, then the least objective under each bound between them. Each search gets an equal
/// share of the evaluations that the searches before it left.
void search_round(Archive& archive, const FrontSettings& settings, double step) {
  int searches = settings.bounds + 2;
  const auto share = [&] {
    const int one = (archive.left() + searches - 1) / searches;
    --searches;
    return one;
  };
  search_locally(archive, objective_of, kNoBound, step, share());
  search_locally(archive, bounded_of, kNoBound, step, share());
  const std::vector<double> bounds = bounds_between_optima(archive.scores(), settings.bounds);
  for (std::size_t i = bounds.size(); i-- > 2 && searches > 0;)
    search_locally(archive, objective_of, bounds[i - 1], step, share());
}

/// Looks everywhere, from the best start.
void search_globally(Archive& archive, const FrontSettings& settings, int evaluations) {
  if (evaluations <= 0) return;
  const std::optional<std::size_t> best = best_within(archive.scores(), objective_of, kNoBound);
  const std::vector<double> from = best ? archive.point(*best).at : std::vector<double>(settings.dimensions, 0.5);
  const auto population = static_cast<unsigned>(kPopulationPerDimension * (settings.dimensions + 1));
  optimise({.archive = archive, .value = objective_of}, NLOPT_GN_CRS2_LM, from, 0.5, evaluations, population);
}

}  // namespace

std::vector<ScoredPoint> search_front(const FrontSettings& settings, const Scoring& score,
                                      const std::stop_token& stop) {
  Archive archive(settings, score, stop);
  for (const std::vector<double>& start : settings.starts)
    if (!archive.exhausted()) (void)archive.at(start);
  nlopt_srand(static_cast<unsigned long>(settings.seed));  // NLopt keeps one generator for each thread
  search_globally(archive, settings, static_cast<int>(kShareOfGlobal * archive.left()));
  if (!best_within(archive.scores(), objective_of, kNoBound)) search_globally(archive, settings, archive.left());
  double step = kFirstStep;
  for (int before = -1; !archive.exhausted() && before != archive.left(); step *= 0.5) {
    before = archive.left();
    search_round(archive, settings, step);
  }
  return std::move(archive).take();
}

std::vector<std::size_t> non_dominated(std::span<const std::optional<Score>> scores) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < scores.size(); ++i)
    if (scores[i]) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(scores[a]->bounded, scores[a]->objective) < std::pair(scores[b]->bounded, scores[b]->objective);
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || scores[i]->objective < scores[front.back()]->objective) front.push_back(i);
  return front;
}

std::vector<double> bounds_between_optima(std::span<const std::optional<Score>> scores, int between) {
  const std::vector<std::size_t> front = non_dominated(scores);
  if (front.empty()) return {};
  const double least = scores[front.front()]->bounded;
  const double most = scores[front.back()]->bounded;
  if (front.size() == 1) return {least};
  std::vector<double> bounds;
  for (int i = 0; i <= between + 1; ++i)
    bounds.push_back(std::lerp(least, most, static_cast<double>(i) / (between + 1)));
  return bounds;
}

std::vector<std::size_t> front_of(std::span<const std::optional<Score>> scores, int between) {
  const std::vector<std::size_t> all = non_dominated(scores);
  std::vector<std::size_t> front;
  for (const double bound : bounds_between_optima(scores, between)) {
    std::optional<std::size_t> last;
    for (const std::size_t i : all)
      if (scores[i]->bounded <= bound * kWithin) last = i;
    if (last && (front.empty() || front.back() != *last)) front.push_back(*last);
  }
  return front;
}

}  // namespace telepalp::study
