#include "haptic_station/surface/foresight/past_predictions.h"

#include <algorithm>
#include <numeric>

namespace telepalp::surface {
namespace {

/// Displacement by the station's own prediction, by the straight one, and by the way to the mean place, each alone [m].
struct Predicted {
  double own_m = 0.0;
  double straight_m = 0.0;
  double to_mean_m = 0.0;
};

// Root mean square over the cells. A patient who sits up goes farther from the mean place, and does not swing: the
// swing then neither learns nor counts as better than the other predictions.
constexpr double kFarthestSwing_m = 0.005;

Predicted predicted(const MotionTerms& terms, const MotionBasis& basis) noexcept {
  Predicted by;
  for (std::size_t k = 0; k < kStraightTerm; ++k) by.own_m += static_cast<double>(terms[k] * basis.value[k]);
  by.straight_m = static_cast<double>(terms[kStraightTerm] * basis.value[kStraightTerm]);
  by.to_mean_m = static_cast<double>(terms[kMeanTerm] * basis.value[kMeanTerm]);
  return by;
}

double square(double value) noexcept { return value * value; }

/// Mean square distance of the measured cells from their mean places [m²].
double distance_m2(std::span<const MotionTerms> terms, std::span<const float> weight) noexcept {
  double sum = 1e-30, weighted_m2 = 0.0;
  for (std::size_t at = 0; at < terms.size(); ++at) {
    sum += static_cast<double>(weight[at]);
    weighted_m2 += static_cast<double>(weight[at]) * square(static_cast<double>(terms[at][kMeanTerm]));
  }
  return weighted_m2 / sum;
}

}  // namespace

/// The newest prediction that is at least `age_s` old. nullptr: there is none, or it is too old to tell about this age.
const PastPredictions::Past* PastPredictions::made_before(double age_s) const noexcept {
  const auto then =
      std::find_if(past_.rbegin(), past_.rend(), [&](const Past& past) { return now_s_ - past.at_s >= age_s; });
  return then != past_.rend() && now_s_ - then->at_s < 2.0 * age_s ? &*then : nullptr;
}

/// Judges the predictions that `then` made for this instant, at the age of index `age`.
void PastPredictions::judge_past(const Past& then, std::size_t age, std::span<const float> measured_m,
                                 std::span<const float> weight, double dt_s) noexcept {
  const MotionBasis basis = motion_basis(then.model, now_s_ - then.at_s);
  const OfThree& mean = then.mean[age];
  const SwingRegression::Shares& swings = then.swings[age];
  const double sum = std::accumulate(weight.begin(), weight.end(), 1e-30);
  const bool near = distance_m2(then.terms, weight) <= square(kFarthestSwing_m);
  SquareErrors errors;
  for (std::size_t at = 0; at < measured_m.size(); ++at) {
    const double counts = static_cast<double>(weight[at]) / sum;
    const auto went_m = static_cast<double>(measured_m[at] - then.displacement_m[at]);
    const Predicted by = predicted(then.terms[at], basis);
    errors.own += counts * square(went_m - by.own_m);
    errors.holding += counts * square(went_m);
    errors.straight += counts * square(went_m - by.straight_m);
    errors.mean += counts * square(went_m - mean[0] * by.own_m - mean[2] * by.straight_m);
    errors.swing += counts * square(went_m - swings.to_mean * by.to_mean_m - swings.straight * by.straight_m);
    if (near) swing_[age].add({went_m, by.to_mean_m, by.straight_m}, counts * dt_s);
  }
  if (!near) errors.swing = std::max(errors.swing, errors.mean);
  by_age_[age].add(errors, dt_s);
}

void PastPredictions::judge(std::span<const float> measured_m, std::span<const float> weight, double dt_s) {
  now_s_ += dt_s;
  for (std::size_t i = 0; i < by_age_.size(); ++i) {
    by_age_[i].pass(dt_s);
    swing_[i].pass(dt_s);
    if (const Past* const then = made_before(kForesightAges_s[i])) judge_past(*then, i, measured_m, weight, dt_s);
  }
}

void PastPredictions::remember(std::span<const float> displacement_m, std::span<const MotionTerms> terms,
                               const MotionModel& model) {
  Past past{now_s_, {displacement_m.begin(), displacement_m.end()}, {terms.begin(), terms.end()}, model, {}, {}};
  past.model.own = past.model.straight = past.model.to_mean = kFullForesight;
  for (std::size_t i = 0; i < by_age_.size(); ++i) {
    past.mean[i] = by_age_[i].short_term();
    past.swings[i] = swing_[i].shares();
  }
  past_.push_back(std::move(past));
  while (past_.size() > 1 && now_s_ - past_[1].at_s >= kForesightAges_s.back()) past_.pop_front();
}

ForesightShare PastPredictions::weights_of(std::size_t prediction) const noexcept {
  ForesightShare share{};
  for (std::size_t i = 0; i < by_age_.size(); ++i) share[i] = by_age_[i].weights()[prediction];
  return share;
}

/// The swing's prediction contains a share of the straight one.
ForesightShare PastPredictions::straight() const noexcept {
  ForesightShare share = weights_of(2);
  const ForesightShare swings = weights_of(3);
  for (std::size_t i = 0; i < share.size(); ++i) share[i] += swings[i] * swing_[i].shares().straight;
  return share;
}

ForesightShare PastPredictions::to_mean() const noexcept {
  ForesightShare share = weights_of(3);
  for (std::size_t i = 0; i < share.size(); ++i) share[i] *= swing_[i].shares().to_mean;
  return share;
}

}  // namespace telepalp::surface
