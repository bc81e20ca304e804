#include "haptic_station/surface/temporal/prediction_mixture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace telepalp::surface {
namespace {

constexpr double kLately_s = 0.3;
constexpr double kLong_s = 10.0;
constexpr double kSharpness = 16.0;
constexpr double kNoise_m2 = 1e-10;  // (0.01 mm)²: errors below are equal

/// Advances a running mean whose memory is `over_s`.
void forget(PredictionErrors& mean, const PredictionErrors& now, double dt_s, double over_s) noexcept {
  const double gain = 1.0 - std::exp(-dt_s / over_s);
  mean.hold_m2 += gain * (now.hold_m2 - mean.hold_m2);
  mean.straight_m2 += gain * (now.straight_m2 - mean.straight_m2);
  mean.modelled_m2 += gain * (now.modelled_m2 - mean.modelled_m2);
  mean.mixture_m2 += gain * (now.mixture_m2 - mean.mixture_m2);
}

/// A prediction's terms at one age: the straight one, and the sum of the others.
struct Moved {
  float straight_m;
  float modelled_m;
};

Moved moved(const MotionTerms& terms, const MotionBasis& basis) noexcept {
  Moved by{terms[kStraightTerm] * basis.value[kStraightTerm], 0.0F};
  for (std::size_t term = 0; term < kStraightTerm; ++term) by.modelled_m += terms[term] * basis.value[term];
  return by;
}

/// Mean square errors of `past`, whose age is now `age_s`.
PredictionErrors errors_of(const FramePrediction& past, const PredictionWeights& mixture, double age_s,
                           std::span<const float> measured_m, std::span<const float> weight) noexcept {
  MotionModel whole = past.model;
  whole.straight = whole.modelled = kFullForesight;
  const MotionBasis basis = motion_basis(whole, age_s);
  const auto straight = static_cast<float>(mixture.straight);
  const auto modelled = static_cast<float>(mixture.modelled);
  PredictionErrors sum;
  double total = 1e-30;
  for (std::size_t i = 0; i < measured_m.size(); ++i) {
    if (weight[i] <= 0.0F) continue;
    const Moved by = moved(past.terms[i], basis);
    const float came_m = measured_m[i] - past.displacement_m[i];
    const auto squared = [came_m, w = static_cast<double>(weight[i])](float said_m) {
      const auto off_m = static_cast<double>(came_m - said_m);
      return w * off_m * off_m;
    };
    total += static_cast<double>(weight[i]);
    sum.hold_m2 += squared(0.0F);
    sum.straight_m2 += squared(by.straight_m);
    sum.modelled_m2 += squared(by.modelled_m);
    sum.mixture_m2 += squared(straight * by.straight_m + modelled * by.modelled_m);
  }
  for (double* one : {&sum.hold_m2, &sum.straight_m2, &sum.modelled_m2, &sum.mixture_m2}) *one /= total;
  return sum;
}

}  // namespace

PredictionWeights mixture_of(const PredictionErrors& lately) noexcept {
  const auto weight = [](double error_m2) { return 1.0 / ((error_m2 + kNoise_m2) * (error_m2 + kNoise_m2)); };
  const double hold = weight(lately.hold_m2);
  const double straight = weight(lately.straight_m2);
  const double modelled = weight(lately.modelled_m2);
  const double sum = hold + straight + modelled;
  return {straight / sum, modelled / sum};
}

PredictionWeights chosen(const PredictionErrors& over_long, const PredictionWeights& mixture) noexcept {
  const double least_m2 = std::min({over_long.hold_m2, over_long.modelled_m2, over_long.mixture_m2}) + kNoise_m2;
  const auto weight = [least_m2](double error_m2) { return std::pow(least_m2 / (error_m2 + kNoise_m2), kSharpness); };
  const double hold = weight(over_long.hold_m2);
  const double modelled = weight(over_long.modelled_m2);
  const double mixed = weight(over_long.mixture_m2);
  const double sum = hold + modelled + mixed;
  return {mixed * mixture.straight / sum, (modelled + mixed * mixture.modelled) / sum};
}

ForesightShare PredictionMixture::straight() const noexcept {
  ForesightShare share{};
  for (std::size_t age = 0; age < judges_.size(); ++age) share[age] = judges_[age].chosen.straight;
  return share;
}

ForesightShare PredictionMixture::modelled() const noexcept {
  ForesightShare share{};
  for (std::size_t age = 0; age < judges_.size(); ++age) share[age] = judges_[age].chosen.modelled;
  return share;
}

void PredictionMixture::judge(std::size_t age, std::span<const float> measured_m, std::span<const float> weight,
                              double dt_s) {
  Judge& one = judges_[age];
  const double ahead_s = kForesightAges_s[age];
  const auto then =
      std::find_if(past_.rbegin(), past_.rend(), [&](const Past& past) { return now_s_ - past.at_s >= ahead_s; });
  if (then == past_.rend() || now_s_ - then->at_s >= 2.0 * ahead_s) return;
  const PredictionErrors now = errors_of(then->prediction, then->mixture[age], now_s_ - then->at_s, measured_m, weight);
  forget(one.lately, now, dt_s, kLately_s);
  forget(one.over_long, now, dt_s, kLong_s);
  one.mixture = mixture_of(one.lately);
  one.chosen = chosen(one.over_long, one.mixture);
}

void PredictionMixture::add(std::span<const float> measured_m, std::span<const float> weight, FramePrediction now,
                            double dt_s) {
  now_s_ += dt_s;
  Past frame{.at_s = now_s_, .prediction = std::move(now), .mixture = {}};
  for (std::size_t age = 0; age < judges_.size(); ++age) {
    judge(age, measured_m, weight, dt_s);
    frame.mixture[age] = judges_[age].mixture;
  }
  past_.push_back(std::move(frame));
  while (past_.size() > 1 && now_s_ - past_[1].at_s >= kForesightAges_s.back()) past_.pop_front();
}

}  // namespace telepalp::surface
