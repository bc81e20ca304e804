#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

#include "proto/words/time.h"

namespace telepalp::bench {

/// A hand prediction to compare with: a Kalman filter whose noise is fixed in advance, with white acceleration. The
/// velocity dies away with the time constants, or never does when they are infinite.
class FixedKalman {
 public:
  struct Settings {
    double noise_m = 0.0005;
    double acceleration_m_per_s2 = 1.0;  ///< intensity [m/s^2 / sqrt(Hz)]
    double memory_s = 0.8;               ///< between samples
    double memory_ahead_s = 0.06;        ///< after the newest sample
  };
  explicit FixedKalman(const Settings& settings) noexcept : settings_(settings) {}

  void update(SessionTime at, const Eigen::Vector3d& hand_m) noexcept {
    const double dt_s = newest_ ? to_seconds(at - *newest_) : 1.0;
    newest_ = at;
    const double noise_m2 = settings_.noise_m * settings_.noise_m;
    if (dt_s > kRestartAfter_s) {
      motion_.setZero();
      motion_.row(0) = hand_m.transpose();
      covariance_ << noise_m2, 0.0, 0.0, 0.25;
      return;
    }
    const Eigen::Matrix2d step = transition(dt_s, settings_.memory_s);
    Eigen::Matrix2d process;
    process << dt_s * dt_s * dt_s / 3.0, dt_s * dt_s / 2.0, dt_s * dt_s / 2.0, dt_s;
    const double intensity = settings_.acceleration_m_per_s2 * settings_.acceleration_m_per_s2;
    const Eigen::Matrix2d spread = step * covariance_ * step.transpose() + intensity * process;
    const Eigen::Vector2d gain = spread.col(0) / (spread(0, 0) + noise_m2);
    const Motion predicted = step * motion_;
    motion_ = predicted + gain * (hand_m.transpose() - predicted.row(0));
    Eigen::Matrix2d rest = Eigen::Matrix2d::Identity();
    rest.col(0) -= gain;
    covariance_ = rest * spread * rest.transpose() + noise_m2 * gain * gain.transpose();
  }

  [[nodiscard]] Eigen::Vector3d predict(SessionTime when) const noexcept {
    const double ahead_s = std::clamp(to_seconds(when - *newest_), 0.0, 0.05);
    return (transition(ahead_s, settings_.memory_ahead_s) * motion_).row(0).transpose();
  }

 private:
  using Motion = Eigen::Matrix<double, 2, 3>;  ///< rows: position, velocity; columns: axes
  static constexpr double kRestartAfter_s = 0.2;

  [[nodiscard]] static Eigen::Matrix2d transition(double dt_s, double memory_s) noexcept {
    Eigen::Matrix2d step;
    const bool dies_away = std::isfinite(memory_s);
    const double left = dies_away ? std::exp(-dt_s / memory_s) : 1.0;
    step << 1.0, dies_away ? memory_s * (1.0 - left) : dt_s, 0.0, left;
    return step;
  }

  Settings settings_;
  Motion motion_ = Motion::Zero();
  Eigen::Matrix2d covariance_ = Eigen::Matrix2d::Zero();
  std::optional<SessionTime> newest_;
};

inline constexpr FixedKalman::Settings kFixedDamped{};
inline constexpr FixedKalman::Settings kFixedVelocity{.memory_s = INFINITY, .memory_ahead_s = INFINITY};

}  // namespace telepalp::bench
