#include "haptic_station/surface/foresight/prediction_weights.h"

#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

constexpr double kErredLately_s = 0.3;  // a shift of 0.2 to 0.9 s must be found while it lasts
constexpr double kLong_s = 10.0;        // three breaths; a patient who coughs does so again within this time
constexpr double kLatelyPower = 2.0;
constexpr double kLongPower = 16.0;  // with 8, a cough errs by 1.06 times as much as the better prediction
constexpr double kNoise_m = 2e-5;    // adds to each error, so that a patient at rest does not choose by noise
// The swing counts only where its mean square error is far below the others'. Without this factor, a patient who coughs
// is shown with 1.4 instead of 1.15 times the error of an ideal display, at a delay of 50 ms.
// With 2, it sufficed for coughs, but the skin after a gap or a shift was drawn back to where it had been.
constexpr double kSwingHandicap = 5.0;
constexpr double kFirstError_m2_s = 9e-8;  // prior: all but the station's own have erred by 0.3 mm for 1 s

template <std::size_t kCount>
std::array<double, kCount> inverse_powers(const std::array<double, kCount>& mean_square_m2, double power) noexcept {
  const double least_m2 = *std::min_element(mean_square_m2.begin(), mean_square_m2.end());
  std::array<double, kCount> weight{};
  double sum = 0.0;
  for (std::size_t i = 0; i < kCount; ++i) sum += weight[i] = std::pow(least_m2 / mean_square_m2[i], power);
  for (double& one : weight) one /= sum;
  return weight;
}

}  // namespace

OfThree inverse_power_weights(const OfThree& mean_square_m2, double power) noexcept {
  return inverse_powers(mean_square_m2, power);
}

void PredictionWeights::pass(double dt_s) noexcept {
  for (double& sum : lately_m2_s_) sum *= std::exp(-dt_s / kErredLately_s);
  const double keep = std::exp(-dt_s / kLong_s);
  for (double& sum : long_m2_s_) sum *= keep;
  prior_ *= keep;
}

void PredictionWeights::add(const SquareErrors& errors, double dt_s) noexcept {
  const OfThree lately{errors.own, errors.holding, errors.straight};
  const OfFour over_long{errors.own, errors.holding, errors.mean, errors.swing};
  for (std::size_t i = 0; i < lately.size(); ++i) lately_m2_s_[i] += lately[i] * dt_s;
  for (std::size_t i = 0; i < over_long.size(); ++i) long_m2_s_[i] += over_long[i] * dt_s;
}

OfThree PredictionWeights::short_term() const noexcept {
  OfThree sum = lately_m2_s_;
  for (double& one : sum) one += kNoise_m * kNoise_m * kErredLately_s;
  return inverse_power_weights(sum, kLatelyPower);
}

OfFour PredictionWeights::weights() const noexcept {
  OfFour sum = long_m2_s_;
  for (double& one : sum) one += kNoise_m * kNoise_m * kLong_s;
  for (std::size_t i = 1; i < sum.size(); ++i) sum[i] += prior_ * kFirstError_m2_s;
  sum[3] *= kSwingHandicap;
  const OfFour second = inverse_powers(sum, kLongPower);
  const OfThree first = short_term();
  return {second[0] + second[2] * first[0], second[1] + second[2] * first[1], second[2] * first[2], second[3]};
}

}  // namespace telepalp::surface
