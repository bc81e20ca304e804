#include "haptic_station/control/parts/heat_warning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace telepalp::control {
namespace {

constexpr double kAnnounced_s = 4.0;   // time from the warning to the lower force
constexpr double kAmplitude_N = 0.12;  // a pressing hand feels it clearly, and it changes by at most 0.015 N a tick
constexpr double kMostShare = 0.1;     // of the force: a faint force can reverse within a tick, and its vibration too
constexpr double kRate_hz = 40.0;
constexpr double kRises_N_per_s = 0.5;
constexpr double kSmooth_s = 0.2;

}  // namespace

Eigen::Vector3d HeatWarning::step(const Eigen::Vector3d& force_N, const ForceLimiter& limiter, double dt_s) noexcept {
  const double norm_N = force_N.norm();
  smooth_N_ += (norm_N - smooth_N_) * (1.0 - smooth_left_.of(-dt_s / kSmooth_s));
  yields_in_s_ = limiter.holds_for_s(smooth_N_);
  const double wanted_N = yields_in_s_ < kAnnounced_s ? kAmplitude_N : 0.0;
  const double most_N = kRises_N_per_s * dt_s;
  amplitude_N_ += std::clamp(wanted_N - amplitude_N_, -most_N, most_N);
  if (amplitude_N_ <= 0.0 || norm_N <= 0.0) return Eigen::Vector3d::Zero();
  turns_ = std::fmod(turns_ + kRate_hz * dt_s, 1.0);
  const double amplitude_N = std::min(amplitude_N_, kMostShare * norm_N);
  return force_N / norm_N * (amplitude_N * std::sin(2.0 * std::numbers::pi * turns_));
}

}  // namespace telepalp::control
