#pragma once

#include <Eigen/Core>

namespace telepalp::tracking {

/// Estimates a tracker's measurement noise from its own samples, without a model of the hand (after Mehra 1970, the
/// autocovariance of the innovations). The innovation is a sample minus the position that the two samples before it
/// predict for its time at constant velocity. White noise makes successive innovations point in opposite directions; a
/// hand that speeds up or brakes makes them point in the same direction. So the noise variance follows from their
/// covariance, at any sample rate, and is zero for a tracker that smooths its samples. No allocation.
class SampleNoise {
 public:
  explicit SampleNoise(double memory_s) noexcept : memory_s_(memory_s) {}

  /// Starts a movement at this sample, which does not continue the last movement. The estimated variance is kept.
  void begin_movement(const Eigen::Vector3d& sample_m) noexcept;
  /// A sample `dt_s` > 0 after the last one.
  void add(const Eigen::Vector3d& sample_m, double dt_s) noexcept;

  [[nodiscard]] double variance_m2() const noexcept { return variance_m2_; }  ///< per axis

 private:
  double memory_s_;
  int samples_ = 0;  ///< number of samples of this movement, counted up to 3
  Eigen::Vector3d last_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d step_m_per_s_ = Eigen::Vector3d::Zero();  ///< velocity from the last sample but one to the last one
  Eigen::Vector3d innovation_m_ = Eigen::Vector3d::Zero();
  double dt_s_ = 0.0;        ///< between the last two samples
  double ratio_ = 1.0;       ///< last interval between samples / the one before
  double covariance_ = 0.0;  ///< weighted sum of -1/3 times the scalar product of successive innovations
  double share_ = 0.0;       ///< weighted sum of the values that `covariance_` would have for unit noise
  double variance_m2_ = 0.0;
};

}  // namespace telepalp::tracking
