#include "haptic_station/tracking/hand_estimate.h"

#include <algorithm>
#include <cmath>

namespace telepalp::tracking {
namespace {

constexpr double kSurpriseMemory_s = 0.05;     // time over which the hand's changes of velocity are estimated
constexpr double kLongestPrediction_s = 0.05;  // at a greater age the predicted position no longer changes
constexpr double kRestartAfter_s = 0.2;        // the filter restarts after a longer gap between samples

constexpr double kStartSpeed_m_per_s = 0.5;  // standard deviation of the velocity after a restart
constexpr double kLeastProcess_m2_per_s3 = 1e-4;
constexpr double kRounding_m2 = 1e-14;

Eigen::Matrix2d transition(double dt_s) noexcept {
  Eigen::Matrix2d step = Eigen::Matrix2d::Identity();
  step(0, 1) = dt_s;
  return step;
}

/// Process noise of unit intensity: the velocity changes right after a sample and then stays. With small measurement
/// noise, the filter's velocity is then the mean velocity between the last two samples.
Eigen::Matrix2d process_noise(double dt_s) noexcept {
  const double dt2 = dt_s * dt_s;
  Eigen::Matrix2d q;
  q << dt2 * dt_s, dt2, dt2, dt_s;
  return q;
}

}  // namespace

double HandEstimate::noise_m() const noexcept { return std::sqrt(noise_.variance_m2()); }

void HandEstimate::restart(SessionTime at, const Point<HapticBase>& hand) noexcept {
  motion_.setZero();
  motion_.row(0) = hand.m.transpose();
  covariance_.setZero();
  covariance_(0, 0) = noise_.variance_m2();
  covariance_(1, 1) = kStartSpeed_m_per_s * kStartSpeed_m_per_s;
  noise_.begin_movement(hand.m);
  persistence_.begin_movement();
  surprise_m2_ = 0.0;
  newest_ = received_ = at;
  implausible_s_ = agree_s_ = 0.0;
  started_ = true;
}

/// From one sample to the next a hand can be fast. While samples are rejected it may go on at an ordinary speed, but
/// not far: after a longer time nothing is known about its place.
bool HandEstimate::is_jump(SessionTime at, const Point<HapticBase>& hand) const noexcept {
  constexpr double kOrdinary_m_per_s = 1.5;
  constexpr double kFarthest_m = 0.1;
  constexpr double kShortest_s = 0.005;
  const double since_s = std::max(to_seconds(at - received_), kShortest_s);
  const double from_last_m = (hand.m.transpose() - motion_.row(0)).norm();
  const double meanwhile_m = std::min(kOrdinary_m_per_s * to_seconds(received_ - newest_), kFarthest_m);
  return from_last_m > settings_.fastest_m_per_s * since_s + meanwhile_m;
}

/// Rejected samples that agree with each other for long enough are accepted.
Taken HandEstimate::hold(SessionTime at, const Point<HapticBase>& hand) noexcept {
  const double since_s = to_seconds(at - received_);
  const bool agrees = implausible_s_ > 0.0 && (hand.m - held_at_.m).norm() <= settings_.fastest_m_per_s * since_s;
  agree_s_ = agrees ? agree_s_ + since_s : 0.0;
  if (agree_s_ >= settings_.believed_after_s) return restart(at, hand), Taken::Restarted;
  ++refused_;
  implausible_s_ = to_seconds(at - newest_);
  held_at_ = hand;
  received_ = at;
  return Taken::Jump;
}

/// The process noise is the innovations' mean square minus the value that the filter expects. Half the square of a
/// single large innovation counts at once, so that a hand that starts to move is followed without delay.
void HandEstimate::adapt(double surprise_m2, double expected_m2, double dt_s) noexcept {
  const double remembered = surprise_m2_ > 0.0 ? std::exp(-dt_s / kSurpriseMemory_s) : 0.0;
  surprise_m2_ += (1.0 - remembered) * (surprise_m2 - surprise_m2_);
  const double unexpected_m2 = std::max(surprise_m2_, 0.5 * surprise_m2) - expected_m2 - noise_.variance_m2();
  process_m2_per_s3_ = std::max(kLeastProcess_m2_per_s3, unexpected_m2 / (dt_s * dt_s * dt_s));
}

void HandEstimate::filter(const Point<HapticBase>& hand, double dt_s) noexcept {
  noise_.add(hand.m, dt_s);
  const Eigen::Matrix2d step = transition(dt_s);
  const Motion predicted = step * motion_;
  const Eigen::RowVector3d innovation_m = hand.m.transpose() - predicted.row(0);
  Eigen::Matrix2d spread = step * covariance_ * step.transpose();
  adapt(innovation_m.squaredNorm() / 3.0, spread(0, 0), dt_s);
  spread += process_m2_per_s3_ * process_noise(dt_s);
  const double noise_m2 = noise_.variance_m2();
  const Eigen::Vector2d gain = spread.col(0) / (spread(0, 0) + noise_m2 + kRounding_m2);
  motion_ = predicted + gain * innovation_m;
  // Joseph's form: the covariance stays symmetric and positive, which the plain update loses to rounding.
  Eigen::Matrix2d rest = Eigen::Matrix2d::Identity();
  rest.col(0) -= gain;
  covariance_ = rest * spread * rest.transpose() + noise_m2 * gain * gain.transpose();
}

Taken HandEstimate::update(SessionTime at, const Point<HapticBase>& hand) noexcept {
  if (!hand.m.allFinite()) return ++refused_, Taken::NotFinite;
  const double since_s = started_ ? to_seconds(at - received_) : 0.0;
  if (!started_ || since_s > kRestartAfter_s) return restart(at, hand), Taken::Restarted;
  if (since_s <= 0.0) return ++refused_, Taken::OutOfOrder;
  if (is_jump(at, hand)) return hold(at, hand);
  const double dt_s = to_seconds(at - newest_);
  filter(hand, dt_s);
  persistence_.add(at, motion_.row(0).transpose(), motion_.row(1).transpose(), dt_s);
  newest_ = received_ = at;
  implausible_s_ = agree_s_ = 0.0;
  return Taken::Used;
}

HandPrediction HandEstimate::predict(SessionTime now) const noexcept {
  if (!started_) return {};
  const double age_s = to_seconds(now - newest_);
  const double dt_s = std::clamp(age_s, 0.0, kLongestPrediction_s);
  const bool held = age_s > kLongestPrediction_s;
  const Eigen::Matrix2d step = transition(dt_s);
  const double spread_m2 = (step * covariance_ * step.transpose())(0, 0);
  const double random_m2 = process_m2_per_s3_ * dt_s * dt_s * dt_s / 3.0;  // white acceleration
  return {.at = {(motion_.row(0) + persistence_.reach_s(dt_s) * motion_.row(1)).transpose()},
          .velocity = {held ? Eigen::Vector3d::Zero().eval()
                            : (persistence_.left(dt_s) * motion_.row(1)).transpose().eval()},
          .sigma_m = std::sqrt(spread_m2 + random_m2),
          .age_s = age_s,
          .implausible_s = implausible_s_,
          .valid = true};
}

}  // namespace telepalp::tracking
