#include "haptic_station/control/safety/force_limiter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace telepalp::control {
namespace {

constexpr double kTaper = 0.6;  // share of the heat range over which the bound falls

/// `vector` shortened to `length` if it is longer. It is first divided by its largest component, so that a huge vector
/// does not overflow. The result is slightly shorter than `length`, so that rounding never exceeds it.
Eigen::Vector3d shortened(const Eigen::Vector3d& vector, double length) noexcept {
  const double largest = vector.cwiseAbs().maxCoeff();
  if (largest <= 0.0) return vector;
  const Eigen::Vector3d scaled = vector / largest;
  const double norm = scaled.norm();
  const double most = length * (1.0 - 1e-14);
  return norm * largest <= most ? vector : Eigen::Vector3d(scaled * (most / norm));
}

}  // namespace

double ForceLimiter::holds_for_s(double force_N) const noexcept {
  constexpr double kNever_s = std::numeric_limits<double>::infinity();
  if (force_N <= limits_.continuous_N || limits_.peak_N <= limits_.continuous_N) return kNever_s;
  const double full_N2 = limits_.continuous_N * limits_.continuous_N;
  const double left = (force_N - limits_.continuous_N) / (limits_.peak_N - limits_.continuous_N);
  const double yields_at_N2 = full_N2 * (1.0 - kTaper * std::min(left, 1.0));
  if (heat_N2_ >= yields_at_N2) return 0.0;
  const double square_N2 = force_N * force_N;
  return limits_.thermal_time_s * std::log((square_N2 - heat_N2_) / (square_N2 - yields_at_N2));
}

double ForceLimiter::heat_bound_N() const noexcept {
  const double full_N2 = limits_.continuous_N * limits_.continuous_N;
  if (full_N2 <= 0.0) return 0.0;  // continuous_N is 0: no force is allowed at any heat
  const double left = std::clamp((full_N2 - heat_N2_) / (kTaper * full_N2), 0.0, 1.0);
  return limits_.continuous_N + (limits_.peak_N - limits_.continuous_N) * left;
}

double ForceLimiter::bound_N() const noexcept { return std::min(heat_bound_N(), device_N_); }

void ForceLimiter::device_gives(const ports::DevicePower& power) noexcept {
  device_N_ = power.most_N >= 0.0 ? power.most_N : 0.0;
  const double most_N = std::min(limits_.peak_N, device_N_);
  lever_m_ = power.most_N_m > 0.0 && most_N > 0.0 ? power.most_N_m / most_N : 0.0;
}

/// A device that no longer gives torques gets none from the next tick on, whatever the rate of change.
Torque<HapticBase> ForceLimiter::limit_torque(const Torque<HapticBase>& wanted, double dt_s) noexcept {
  if (lever_m_ <= 0.0) return {};
  const Eigen::Vector3d target =
      faulted_ ? Eigen::Vector3d::Zero().eval() : shortened(wanted.N_m, lever_m_ * bound_N());
  const Eigen::Vector3d before = shortened(given_.torque.N_m, lever_m_ * bound_N());
  return {before + shortened(target - before, lever_m_ * limits_.slew_N_per_s * dt_s)};
}

Wrench<HapticBase> ForceLimiter::limit(const Wrench<HapticBase>& wanted, double dt_s) noexcept {
  const double dt = std::isfinite(dt_s) ? std::clamp(dt_s, 0.0, 0.01) : 0.0;
  const bool finite = wanted.force.N.allFinite() && wanted.torque.N_m.allFinite();
  if (!finite) faulted_ = true;
  const Eigen::Vector3d target = faulted_ ? Eigen::Vector3d::Zero().eval() : shortened(wanted.force.N, bound_N());
  const Eigen::Vector3d change = shortened(target - given_.force.N, limits_.slew_N_per_s * dt);
  given_.force.N += change;
  given_.torque = limit_torque(wanted.torque, dt);
  limited_ = !finite || (given_.force.N - wanted.force.N).squaredNorm() > 1e-18 ||
             (given_.torque.N_m - wanted.torque.N_m).squaredNorm() > 1e-18;
  const double turning_N = lever_m_ > 0.0 ? given_.torque.N_m.norm() / lever_m_ : 0.0;
  heat_N2_ += (given_.force.N.squaredNorm() + turning_N * turning_N - heat_N2_) *
              (1.0 - heat_left_.of(-dt / limits_.thermal_time_s));
  return given_;
}

}  // namespace telepalp::control
