#include "haptic_station/surface/temporal/past_predictions.h"

#include <algorithm>

namespace telepalp::surface {
namespace {

/// Displacement by the station's own prediction and by the straight one, each alone [m].
struct Predicted {
  double own_m = 0.0;
  double straight_m = 0.0;
};

Predicted predicted(const MotionTerms& terms, const MotionBasis& basis) noexcept {
  Predicted by;
  for (std::size_t k = 0; k < kStraightTerm; ++k) by.own_m += static_cast<double>(terms[k] * basis.value[k]);
  by.straight_m = static_cast<double>(terms[kStraightTerm] * basis.value[kStraightTerm]);
  return by;
}

double square(double value) noexcept { return value * value; }

}  // namespace

/// The newest prediction that is at least `age_s` old. nullptr: there is none, or it is too old to tell about this age.
const PastPredictions::Past* PastPredictions::made_before(double age_s) const noexcept {
  const auto then =
      std::find_if(past_.rbegin(), past_.rend(), [&](const Past& past) { return now_s_ - past.at_s >= age_s; });
  return then != past_.rend() && now_s_ - then->at_s < 2.0 * age_s ? &*then : nullptr;
}

void PastPredictions::judge(std::span<const float> measured_m, std::span<const float> weight, double dt_s) {
  now_s_ += dt_s;
  for (std::size_t i = 0; i < by_age_.size(); ++i) {
    by_age_[i].pass(dt_s);
    const Past* const then = made_before(kForesightAges_s[i]);
    if (then == nullptr) continue;
    const MotionBasis basis = motion_basis(then->model, now_s_ - then->at_s);
    const OfThree& mean = then->mean[i];
    SquareErrors errors;
    double sum = 1e-30;
    for (std::size_t at = 0; at < measured_m.size(); ++at) {
      const auto counts = static_cast<double>(weight[at]);
      const auto went_m = static_cast<double>(measured_m[at] - then->displacement_m[at]);
      const Predicted by = predicted(then->terms[at], basis);
      sum += counts;
      errors.own += counts * square(went_m - by.own_m);
      errors.holding += counts * square(went_m);
      errors.straight += counts * square(went_m - by.straight_m);
      errors.mean += counts * square(went_m - mean[0] * by.own_m - mean[2] * by.straight_m);
    }
    by_age_[i].add({errors.own / sum, errors.holding / sum, errors.straight / sum, errors.mean / sum}, dt_s);
  }
}

void PastPredictions::remember(std::span<const float> displacement_m, std::span<const MotionTerms> terms,
                               const MotionModel& model) {
  Past past{now_s_, {displacement_m.begin(), displacement_m.end()}, {terms.begin(), terms.end()}, model, {}};
  past.model.own = past.model.straight = kFullForesight;
  for (std::size_t i = 0; i < by_age_.size(); ++i) past.mean[i] = by_age_[i].short_term();
  past_.push_back(std::move(past));
  while (past_.size() > 1 && now_s_ - past_[1].at_s >= kForesightAges_s.back()) past_.pop_front();
}

ForesightShare PastPredictions::weights_of(std::size_t prediction) const noexcept {
  ForesightShare share{};
  for (std::size_t i = 0; i < by_age_.size(); ++i) share[i] = by_age_[i].weights()[prediction];
  return share;
}

}  // namespace telepalp::surface
