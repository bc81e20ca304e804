#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::tracking {

/// Motion model of the hand between samples.
enum class MotionModel {
  DampedVelocity,  ///< the velocity decays exponentially: a moving hand will stop
  ConstantVelocity,
  ConstantAcceleration,  ///< good for slow, smooth movements only; overshoots real hands
};

struct HandEstimateSettings {
  MotionModel model = MotionModel::DampedVelocity;
  double noise_m = 0.0005;             ///< standard deviation of a sample
  double jerk_m_per_s3 = 60.0;         ///< intensity of the white jerk (acceleration model) [m/s^3 / sqrt(Hz)]
  double acceleration_m_per_s2 = 1.0;  ///< intensity of the white acceleration (velocity models) [m/s^2 / sqrt(Hz)]
  double velocity_memory_s = 0.8;      ///< time constant of the velocity's decay between samples
  double prediction_memory_s = 0.06;   ///< time constant after the newest sample; shorter, as the hand may be stopping
  double longest_prediction_s = 0.05;  ///< at a greater age the predicted position no longer changes
  double restart_after_s = 0.2;        ///< the filter restarts after a longer gap between samples
  double fastest_m_per_s = 5.0;        ///< a sample that implies a greater speed is an outlier
  int outliers_until_restart = 5;      ///< after so many outliers in a row, the filter restarts at the newest
};

/// The hand's predicted state at an instant, from the samples before it.
struct HandPrediction {
  Point<HapticBase> at;
  Vector<HapticBase> velocity;  ///< [m/s]
  double sigma_m = 0.0;         ///< standard deviation per axis
  double age_s = 0.0;           ///< age of the newest sample
  bool valid = false;           ///< false: no sample yet
};

/// How update() handled a sample.
enum class Taken { Used, Restarted, NotFinite, OutOfOrder, Outlier };

/// Kalman filter over hand or proxy samples at about 100 Hz, predicted at 2 kHz (S1 II.D). It uses the time stamp of
/// each sample, so jitter, gaps and bursts cause no model error. The restart after a gap bounds its covariance. Axes
/// are independent and share one covariance. No allocation. Owner: control thread.
class HandEstimate {
 public:
  explicit HandEstimate(const HandEstimateSettings& settings = {}) noexcept : settings_(settings) {}

  /// Adds a sample taken at `at`. The estimate changes only when the result is Used or Restarted.
  Taken update(SessionTime at, const Point<HapticBase>& hand) noexcept;
  /// Discards all samples; the next one restarts the filter.
  void forget() noexcept { started_ = false; }
  [[nodiscard]] HandPrediction predict(SessionTime now) const noexcept;
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_; }

 private:
  using Motion = Eigen::Matrix3d;  ///< rows: position, velocity, acceleration; columns: axes

  void restart(SessionTime at, const Point<HapticBase>& hand) noexcept;
  [[nodiscard]] Eigen::Matrix3d transition(double dt_s, double velocity_memory_s) const noexcept;
  [[nodiscard]] Eigen::Matrix3d process_noise(double dt_s) const noexcept;

  HandEstimateSettings settings_;
  Motion motion_ = Motion::Zero();
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  SessionTime newest_{};
  bool started_ = false;
  int outliers_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace telepalp::tracking
