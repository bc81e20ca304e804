#include "haptic_station/surface/temporal/breathing_model.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace telepalp::surface {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr double kBreathsWindow_s = 12.0;
constexpr double kKeepEvery_s = 0.09;  // sample period of the window; breathing has no higher frequencies
constexpr double kSlowest_Hz = 0.10;
constexpr double kFastest_Hz = 0.80;
constexpr double kLeastBreaths = 1.3;  // least number of breaths in the window before a rate is used
constexpr std::size_t kLeastMoments = 16;
constexpr double kLeastAmplitude_m = 2e-4;
constexpr double kMostUnexplained = 0.03;
constexpr double kMostMiss = 0.15;  // greatest deviation from the model, as a share of the amplitude
constexpr double kMiss_m = 1.5e-4;
constexpr int kFitEvery_frames = 6;
constexpr int kSteadyFits = 2;  // five terms fit the beginning of any motion, so the rate must also stay constant
constexpr double kSteadyShare = 0.03;
constexpr double kBelieveOver_s = 0.5;
constexpr double kDoubtAfter_s = 0.1;
constexpr double kDoubtOver_s = 0.2;

BreathTerms terms_at(double phase) noexcept {
  const double c = std::cos(phase);
  const double s = std::sin(phase);
  BreathTerms terms;
  terms << 1.0, c, s, c * c - s * s, 2.0 * s * c;
  return terms;
}

}  // namespace

void BreathingModel::remember(std::span<const float> displacement_m) {
  recent_.push_back({now_s_, {displacement_m.begin(), displacement_m.end()}});
  while (now_s_ - recent_.front().at_s > kBreathsWindow_s) recent_.pop_front();
}

double BreathingModel::signal_of(std::span<const float> displacement_m) const noexcept {
  return std::inner_product(weight_.begin(), weight_.end(), displacement_m.begin(), 0.0);
}

/// Least-squares fit of the signal over the window at one rate; phase 0 is now.
BreathingModel::Fit BreathingModel::fit_at(const std::vector<double>& signal, double rad_per_s) const {
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  BreathTerms right = BreathTerms::Zero();
  double mean = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const BreathTerms terms = terms_at(rad_per_s * (recent_[i].at_s - now_s_));
    normal.noalias() += terms * terms.transpose();
    right += signal[i] * terms;
    mean += signal[i];
    square += signal[i] * signal[i];
  }
  normal.diagonal().array() += 1e-6;
  Fit fit{.rad_per_s = rad_per_s, .unexplained = 1.0, .amplitude_m = 0.0, .coefficients = normal.ldlt().solve(right)};
  const double variance = square - mean * mean / static_cast<double>(signal.size());
  fit.unexplained = variance > 0.0 ? std::max(0.0, square - fit.coefficients.dot(right)) / variance : 1.0;
  fit.amplitude_m = fit.coefficients.segment<2>(1).norm();
  return fit;
}

/// The rate with the best fit: a scan over rates, near the present rate once locked, and then a parabola through the
/// best three.
BreathingModel::Fit BreathingModel::best_fit(const std::vector<double>& signal) const {
  const double span_s = now_s_ - recent_.front().at_s;
  const double slowest = kTau * std::max(kSlowest_Hz, kLeastBreaths / std::max(span_s, 1e-3));
  const double fastest = kTau * kFastest_Hz;
  if (slowest >= fastest || recent_.size() < kLeastMoments) return {};
  const bool locked = confidence_ > 0.5;
  const double step = locked ? 0.01 * fit_.rad_per_s : kTau * 0.15 / span_s;
  const double from = locked ? fit_.rad_per_s - 3.0 * step : slowest;
  const double to = locked ? fit_.rad_per_s + 3.0 * step : fastest;
  Fit best = fit_at(signal, from);
  for (double rate = from + step; rate <= to; rate += step) {
    const Fit fit = fit_at(signal, rate);
    if (fit.unexplained < best.unexplained) best = fit;
  }
  const double low = fit_at(signal, best.rad_per_s - step).unexplained;
  const double high = fit_at(signal, best.rad_per_s + step).unexplained;
  const double bend = low + high - 2.0 * best.unexplained;
  if (bend <= 1e-12) return best;
  const Fit refined = fit_at(signal, best.rad_per_s + std::clamp(0.5 * (low - high) / bend, -1.0, 1.0) * step);
  return refined.unexplained < best.unexplained ? refined : best;
}

void BreathingModel::refit(std::span<const float> weight) {
  const float total = std::accumulate(weight.begin(), weight.end(), 0.0F);
  if (total <= 0.0F || recent_.empty()) return;
  weight_.assign(weight.begin(), weight.end());
  for (float& w : weight_) w /= total;
  std::vector<double> signal;
  signal.reserve(recent_.size());
  for (const Moment& moment : recent_) signal.push_back(signal_of(moment.displacement_m));
  const Fit fresh = best_fit(signal);
  const bool same_rate = std::abs(fresh.rad_per_s - fit_.rad_per_s) < kSteadyShare * fit_.rad_per_s;
  steady_fits_ = same_rate ? steady_fits_ + 1 : 0;
  fit_ = fresh;
  fitted_at_s_ = now_s_;
  if (fit_.rad_per_s > 0.0) fit_cells();
}

/// Fits every cell at the common rate. The regressors, and so the matrix, are the same for all cells.
void BreathingModel::fit_cells() {
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  cells_.assign(weight_.size(), BreathTerms::Zero());
  for (const Moment& moment : recent_) {
    const BreathTerms terms = terms_at(fit_.rad_per_s * (moment.at_s - now_s_));
    normal.noalias() += terms * terms.transpose();
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
      cells_[cell] += static_cast<double>(moment.displacement_m[cell]) * terms;
  }
  normal.diagonal().array() += 1e-6;
  const Eigen::Matrix<double, 5, 5> inverse = normal.ldlt().solve(Eigen::Matrix<double, 5, 5>::Identity());
  for (BreathTerms& cell : cells_) cell = (inverse * cell).eval();
}

bool BreathingModel::follows(double signal_m) const noexcept {
  const double expected = fit_.coefficients.dot(terms_at(fit_.rad_per_s * (now_s_ - fitted_at_s_)));
  return std::abs(signal_m - expected) < std::max(kMiss_m, kMostMiss * fit_.amplitude_m);
}

void BreathingModel::add(std::span<const float> displacement_m, std::span<const float> weight, double dt_s) {
  now_s_ += dt_s;
  since_kept_s_ += dt_s;
  if (since_kept_s_ >= kKeepEvery_s) {
    since_kept_s_ = 0.0;
    remember(displacement_m);
  }
  if (--frames_to_fit_ <= 0) {
    frames_to_fit_ = kFitEvery_frames;
    refit(weight);
  }
  const bool found =
      steady_fits_ >= kSteadyFits && fit_.amplitude_m > kLeastAmplitude_m && fit_.unexplained < kMostUnexplained;
  misses_s_ = found && follows(signal_of(displacement_m)) ? 0.0 : misses_s_ + dt_s;
  if (misses_s_ == 0.0)
    confidence_ = std::min(1.0, confidence_ + dt_s / kBelieveOver_s);
  else if (misses_s_ > kDoubtAfter_s || !found)
    confidence_ = std::max(0.0, confidence_ - dt_s / kDoubtOver_s);
}

/// a cos p + b sin p after a further time τ: (a cos p + b sin p) cos ωτ + (b cos p − a sin p) sin ωτ.
MotionTerms BreathingModel::motion_of(std::size_t cell) const noexcept {
  if (cell >= cells_.size()) return {};
  const BreathTerms at = terms_at(fit_.rad_per_s * (now_s_ - fitted_at_s_));
  const BreathTerms& b = cells_[cell];
  return {0.0F, static_cast<float>(b[1] * at[1] + b[2] * at[2]), static_cast<float>(b[2] * at[1] - b[1] * at[2]),
          static_cast<float>(b[3] * at[3] + b[4] * at[4]), static_cast<float>(b[4] * at[3] - b[3] * at[4])};
}

}  // namespace telepalp::surface
