#include "haptic_station/tracking/attitude_estimate.h"

#include <cmath>

namespace telepalp::tracking {
namespace {

constexpr double kFastest_rad_per_s = 40.0;
constexpr double kForgotten_s = 1.0;

Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& q) noexcept {
  const double sine = q.vec().norm();
  if (sine < 1e-12) return Eigen::Vector3d::Zero();
  const double half_rad = std::atan2(sine, std::abs(q.w()));
  return (q.w() < 0.0 ? -2.0 : 2.0) * half_rad / sine * q.vec();
}

Eigen::Quaterniond turn_by(const Eigen::Vector3d& rotation_rad) noexcept {
  const double angle_rad = rotation_rad.norm();
  if (angle_rad < 1e-12) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, rotation_rad / angle_rad));
}

}  // namespace

AttitudeEstimate::AttitudeEstimate() noexcept : path_({.fastest_m_per_s = kFastest_rad_per_s}) {}

void AttitudeEstimate::forget() noexcept {
  path_.forget();
  started_ = false;
}

Taken AttitudeEstimate::update(SessionTime at, const Eigen::Quaterniond& attitude) noexcept {
  if (!attitude.coeffs().allFinite() || !(attitude.norm() > 0.1)) return Taken::NotFinite;
  const Eigen::Quaterniond unit = attitude.normalized();
  if (!started_) {
    newest_ = unit;
    turned_rad_.setZero();
  }
  const Eigen::Vector3d turned_rad = turned_rad_ + rotation_vector(newest_.conjugate() * unit);
  const Taken taken = path_.update(at, {turned_rad});
  if (taken != Taken::Used && taken != Taken::Restarted) return taken;
  newest_ = unit;
  turned_rad_ = turned_rad;
  started_ = true;
  return taken;
}

std::optional<Eigen::Quaterniond> AttitudeEstimate::predict(SessionTime now) const noexcept {
  const HandPrediction path = path_.predict(now);
  if (!started_ || !path.valid || path.age_s > kForgotten_s) return std::nullopt;
  return (newest_ * turn_by(path.at.m - turned_rad_)).normalized();
}

}  // namespace telepalp::tracking
