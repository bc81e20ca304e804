#include "haptic_station/tracking/hand_estimate.h"

#include <algorithm>
#include <cmath>

namespace telepalp::tracking {

void HandEstimate::restart(SessionTime at, const Point<HapticBase>& hand) noexcept {
  constexpr double kSpeedSigma_m_per_s = 0.5;
  constexpr double kAccelerationSigma_m_per_s2 = 5.0;
  motion_.setZero();
  motion_.row(0) = hand.m.transpose();
  covariance_.setZero();
  covariance_(0, 0) = settings_.noise_m * settings_.noise_m;
  covariance_(1, 1) = kSpeedSigma_m_per_s * kSpeedSigma_m_per_s;
  if (settings_.model == MotionModel::ConstantAcceleration)
    covariance_(2, 2) = kAccelerationSigma_m_per_s2 * kAccelerationSigma_m_per_s2;
  newest_ = at;
  started_ = true;
  outliers_ = 0;
}

Eigen::Matrix3d HandEstimate::transition(double dt, double velocity_memory_s) const noexcept {
  Eigen::Matrix3d step = Eigen::Matrix3d::Identity();
  step(0, 1) = dt;
  if (settings_.model == MotionModel::DampedVelocity) {
    step(1, 1) = std::exp(-dt / velocity_memory_s);
    step(0, 1) = velocity_memory_s * (1.0 - step(1, 1));
  }
  if (settings_.model == MotionModel::ConstantAcceleration) {
    step(1, 2) = dt;
    step(0, 2) = 0.5 * dt * dt;
  }
  return step;
}

Eigen::Matrix3d HandEstimate::process_noise(double dt) const noexcept {
  const double dt2 = dt * dt;
  const double dt3 = dt2 * dt;
  Eigen::Matrix3d q = Eigen::Matrix3d::Zero();
  // The noise of the constant-velocity model serves for the damped velocity, too: over one period of the tracker both
  // agree within a few per cent.
  if (settings_.model != MotionModel::ConstantAcceleration) {
    q(0, 0) = dt3 / 3.0;
    q(0, 1) = q(1, 0) = dt2 / 2.0;
    q(1, 1) = dt;
    return q * settings_.acceleration_m_per_s2 * settings_.acceleration_m_per_s2;
  }
  q(0, 0) = dt3 * dt2 / 20.0;
  q(0, 1) = q(1, 0) = dt2 * dt2 / 8.0;
  q(0, 2) = q(2, 0) = dt3 / 6.0;
  q(1, 1) = dt3 / 3.0;
  q(1, 2) = q(2, 1) = dt2 / 2.0;
  q(2, 2) = dt;
  return q * settings_.jerk_m_per_s3 * settings_.jerk_m_per_s3;
}

Taken HandEstimate::update(SessionTime at, const Point<HapticBase>& hand) noexcept {
  if (!hand.m.allFinite()) return ++refused_, Taken::NotFinite;
  const double dt = started_ ? to_seconds(at - newest_) : 0.0;
  if (!started_ || dt > settings_.restart_after_s) return restart(at, hand), Taken::Restarted;
  if (dt <= 0.0) return ++refused_, Taken::OutOfOrder;

  const Eigen::Matrix3d step = transition(dt, settings_.velocity_memory_s);
  const Motion predicted = step * motion_;
  const Eigen::RowVector3d surprise = hand.m.transpose() - predicted.row(0);
  const double from_last_m = (hand.m.transpose() - motion_.row(0)).norm();
  if (from_last_m > settings_.fastest_m_per_s * std::max(dt, 0.005)) {
    ++refused_;
    if (++outliers_ < settings_.outliers_until_restart) return Taken::Outlier;
    return restart(at, hand), Taken::Restarted;
  }
  outliers_ = 0;
  const Eigen::Matrix3d spread = step * covariance_ * step.transpose() + process_noise(dt);
  const Eigen::Vector3d gain = spread.col(0) / (spread(0, 0) + settings_.noise_m * settings_.noise_m);
  motion_ = predicted + gain * surprise;
  // Joseph's form of the update: the covariance stays symmetric and positive despite rounding.
  Eigen::Matrix3d rest = Eigen::Matrix3d::Identity();
  rest.col(0) -= gain;
  covariance_ = rest * spread * rest.transpose() + settings_.noise_m * settings_.noise_m * gain * gain.transpose();
  newest_ = at;
  return Taken::Used;
}

HandPrediction HandEstimate::predict(SessionTime now) const noexcept {
  if (!started_) return {};
  const double age_s = to_seconds(now - newest_);
  const double dt = std::clamp(age_s, 0.0, settings_.longest_prediction_s);
  const Eigen::Matrix3d step = transition(dt, settings_.prediction_memory_s);
  const Motion motion = step * motion_;
  const Eigen::Matrix3d spread = step * covariance_ * step.transpose() + process_noise(dt);
  const bool held = age_s > settings_.longest_prediction_s;
  return {.at = {motion.row(0).transpose()},
          .velocity = {held ? Eigen::Vector3d::Zero().eval() : motion.row(1).transpose().eval()},
          .sigma_m = std::sqrt(spread(0, 0)),
          .age_s = age_s,
          .valid = true};
}

}  // namespace telepalp::tracking
