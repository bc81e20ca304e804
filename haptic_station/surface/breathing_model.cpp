#include "haptic_station/surface/breathing_model.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace telepalp::surface {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr double kWindow_s = 14.0;
constexpr double kKeepEvery_s = 0.09;  // the window's samples; breathing has nothing faster to say
constexpr double kSlowest_Hz = 0.10;
constexpr double kFastest_Hz = 0.80;
constexpr double kLeastBreaths = 1.4;  // in the window, before a rate is believed
constexpr double kLeastAmplitude_m = 2e-4;
constexpr double kMostUnexplained = 0.03;
constexpr double kMostMiss = 0.15;  // of the amplitude
constexpr double kMiss_m = 1.5e-4;
constexpr int kSearchEvery_frames = 6;
constexpr double kBelieveOver_s = 0.5;
constexpr double kDoubtOver_s = 0.25;

BreathTerms terms_at(double phase) {
  return (BreathTerms() << 1.0, std::cos(phase), std::sin(phase), std::cos(2.0 * phase), std::sin(2.0 * phase))
      .finished();
}

}  // namespace

BreathTerms BreathingModel::terms() const noexcept { return terms_at(phase_rad_); }

/// Least squares over the window, phase counted from its newest moment.
BreathingModel::Fit BreathingModel::fit_at(double rad_per_s) const {
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  BreathTerms right = BreathTerms::Zero();
  double mean = 0.0;
  double square = 0.0;
  for (const Moment& moment : recent_) {
    const BreathTerms terms = terms_at(rad_per_s * (moment.at_s - recent_.back().at_s));
    normal.noalias() += terms * terms.transpose();
    right += moment.displacement_m * terms;
    mean += moment.displacement_m;
    square += moment.displacement_m * moment.displacement_m;
  }
  Fit fit{.rad_per_s = rad_per_s, .unexplained = 1.0, .amplitude_m = 0.0, .coefficients = BreathTerms::Zero()};
  normal.diagonal().array() += 1e-6;
  fit.coefficients = normal.ldlt().solve(right);
  const double variance = square - mean * mean / static_cast<double>(recent_.size());
  const double left = square - fit.coefficients.dot(right);
  fit.unexplained = variance > 0.0 ? std::max(0.0, left / variance) : 1.0;
  fit.amplitude_m = fit.coefficients.segment<2>(1).norm();
  return fit;
}

/// The rate that explains most: a coarse scan, or around the rate in use, then a parabola through the best three.
void BreathingModel::search() {
  const double span_s = recent_.back().at_s - recent_.front().at_s;
  const double slowest = kTau * std::max(kSlowest_Hz, kLeastBreaths / std::max(span_s, 1e-3));
  const double fastest = kTau * kFastest_Hz;
  if (slowest >= fastest || recent_.size() < 16) return;
  const bool tracking = confidence_ > 0.5;
  const double step = tracking ? 0.01 * rad_per_s_ : kTau * 0.15 / std::max(span_s, 1.0);
  const double from = tracking ? std::max(slowest, rad_per_s_ - 3.0 * step) : slowest;
  const double to = tracking ? std::min(fastest, rad_per_s_ + 3.0 * step) : fastest;
  Fit best = fit_at(from);
  for (double rate = from + step; rate <= to; rate += step) {
    const Fit fit = fit_at(rate);
    if (fit.unexplained < best.unexplained) best = fit;
  }
  const double low = fit_at(best.rad_per_s - step).unexplained;
  const double high = fit_at(best.rad_per_s + step).unexplained;
  const double bend = low + high - 2.0 * best.unexplained;
  if (bend > 1e-12) {
    const Fit refined = fit_at(best.rad_per_s + std::clamp(0.5 * (low - high) / bend, -1.0, 1.0) * step);
    if (refined.unexplained < best.unexplained) best = refined;
  }
  fit_ = best;
  fitted_at_s_ = recent_.back().at_s;
}

bool BreathingModel::follows(double displacement_m) const noexcept {
  const double expected = fit_.coefficients.dot(terms_at(fit_.rad_per_s * (now_s_ - fitted_at_s_)));
  return std::abs(displacement_m - expected) < std::max(kMiss_m, kMostMiss * fit_.amplitude_m);
}

void BreathingModel::add(double displacement_m, double dt_s) {
  now_s_ += dt_s;
  phase_rad_ = std::remainder(phase_rad_ + rad_per_s_ * dt_s, kTau);
  since_kept_s_ += dt_s;
  if (since_kept_s_ >= kKeepEvery_s) {
    since_kept_s_ = 0.0;
    recent_.push_back({now_s_, displacement_m});
    while (recent_.back().at_s - recent_.front().at_s > kWindow_s) recent_.pop_front();
  }
  if (--frames_to_search_ <= 0) {
    frames_to_search_ = kSearchEvery_frames;
    search();
  }
  const bool found = fit_.amplitude_m > kLeastAmplitude_m && fit_.unexplained < kMostUnexplained;
  misses_s_ = found && follows(displacement_m) ? 0.0 : misses_s_ + dt_s;
  if (misses_s_ == 0.0) {
    if (confidence_ == 0.0) phase_rad_ = 0.0;
    rad_per_s_ = fit_.rad_per_s;
    confidence_ = std::min(1.0, confidence_ + dt_s / kBelieveOver_s);
  } else if (misses_s_ > 0.1) {
    confidence_ = std::max(0.0, confidence_ - dt_s / kDoubtOver_s);
  }
}

}  // namespace telepalp::surface
