#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::tracking {

/// How the hand moves between samples.
enum class MotionModel {
  DampedVelocity,  ///< the velocity dies away: a hand that moves will stop
  ConstantVelocity,
  ConstantAcceleration,  ///< right for slow smooth movements only; overshoots real hands
};

struct HandEstimateSettings {
  MotionModel model = MotionModel::DampedVelocity;
  double noise_m = 0.0005;             ///< standard deviation of a sample
  double jerk_m_per_s3 = 60.0;         ///< intensity of the white jerk (acceleration model) [m/s^3 / sqrt(Hz)]
  double acceleration_m_per_s2 = 1.0;  ///< intensity of the white acceleration (velocity models) [m/s^2 / sqrt(Hz)]
  double velocity_memory_s = 0.8;      ///< over which the damped velocity dies away from sample to sample
  double prediction_memory_s = 0.06;   ///< and ahead of the newest sample: the hand may be about to stop
  double longest_prediction_s = 0.05;  ///< beyond it the hand is held where the prediction ended
  double restart_after_s = 0.2;        ///< a longer gap forgets the motion before it
  double fastest_m_per_s = 5.0;        ///< a sample that implies more is another hand, or an error
  int outliers_until_restart = 5;      ///< so many of them in a row are believed
};

/// The hand at an instant, by prediction from the samples before it.
struct HandPrediction {
  Point<HapticBase> at;
  Vector<HapticBase> velocity;  ///< [m/s]
  double sigma_m = 0.0;         ///< standard deviation by axis
  double age_s = 0.0;           ///< since the newest sample
  bool valid = false;           ///< false: no sample yet
};

/// What became of a sample.
enum class Taken { Used, Restarted, NotFinite, OutOfOrder, Outlier };

/// Kalman filter over hand or proxy samples at about 100 Hz, asked at 2 kHz (S1 II.D). Works on the samples' own
/// times, so that jitter, gaps and bursts are no error of the model. Its covariance is bounded by the restart after a
/// gap. Axes are independent and share one covariance. No allocation. Owner: control thread.
class HandEstimate {
 public:
  explicit HandEstimate(const HandEstimateSettings& settings = {}) noexcept : settings_(settings) {}

  /// A sample taken at `at`. Only Used and Restarted change the estimate.
  Taken update(SessionTime at, const Point<HapticBase>& hand) noexcept;
  /// Begins anew: no sample yet.
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
