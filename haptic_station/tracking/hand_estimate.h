#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "haptic_station/tracking/sample_noise.h"
#include "haptic_station/tracking/velocity_persistence.h"
#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::tracking {

struct HandEstimateSettings {
  double fastest_m_per_s = 5.0;   ///< a sample that implies a greater speed is a jump and is rejected
  double believed_after_s = 0.5;  ///< after a jump, samples that agree with each other for this time are accepted
};

/// The hand's state at an instant, predicted from the samples before this instant.
struct HandPrediction {
  Point<HapticBase> at;
  Vector<HapticBase> velocity;  ///< [m/s]
  double sigma_m = 0.0;         ///< standard deviation of `at` per axis
  double age_s = 0.0;           ///< age of the newest sample that was accepted
  double implausible_s = 0.0;   ///< how long samples have implied an impossible speed; 0: the newest one is plausible
  bool valid = false;           ///< false: no sample yet
};

/// How update() handled a sample.
enum class Taken { Used, Restarted, NotFinite, OutOfOrder, Jump };

/// Adaptive Kalman filter over samples of the hand at about 100 Hz, predicted at 2 kHz (paper S1, docs/sources.md,
/// II.D). The measurement noise follows from the samples (SampleNoise), the process noise from the newest innovations,
/// and the velocity's time constant from the recent movements (VelocityPersistence). With a tracker that smooths its
/// samples, the filter extrapolates the straight line through the last two samples, at a velocity that decays with this
/// time constant; with a noisy tracker the filter averages. It uses the time stamp of each sample, so jitter, gaps and
/// bursts cause no model error. After a gap of more than 0.2 s it restarts, so its covariance stays bounded. A
/// sample that implies an impossible speed is rejected, and the estimate continues from the accepted samples. Axes are
/// independent and share one covariance. No allocation. Owner: haptic thread.
class HandEstimate {
 public:
  explicit HandEstimate(const HandEstimateSettings& settings = {}) noexcept
      : settings_(settings), noise_(kNoiseMemory_s), persistence_(kVelocityMemory_s, kPersistenceMemory_s) {}

  /// Adds a sample taken at `at`. The estimate changes only when the result is Used or Restarted.
  Taken update(SessionTime at, const Point<HapticBase>& hand) noexcept;
  /// Discards all samples; the next one restarts the filter.
  void forget() noexcept { started_ = false; }
  [[nodiscard]] HandPrediction predict(SessionTime now) const noexcept;
  /// Number of samples that were not finite, out of order or jumps.
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_; }
  /// Estimated standard deviation of a sample, per axis.
  [[nodiscard]] double noise_m() const noexcept;

 private:
  static constexpr double kNoiseMemory_s = 3.0;        ///< time over which the tracker's noise is estimated
  static constexpr double kPersistenceMemory_s = 1.0;  ///< time over which the velocity's time constant is learnt
  static constexpr double kVelocityMemory_s = 0.1;     ///< the velocity's time constant before any movement was seen

  using Motion = Eigen::Matrix<double, 2, 3>;  ///< rows: position, velocity; columns: axes

  void restart(SessionTime at, const Point<HapticBase>& hand) noexcept;
  [[nodiscard]] bool is_jump(SessionTime at, const Point<HapticBase>& hand) const noexcept;
  [[nodiscard]] Taken hold(SessionTime at, const Point<HapticBase>& hand) noexcept;
  void filter(const Point<HapticBase>& hand, double dt_s) noexcept;
  void adapt(double surprise_m2, double expected_m2, double dt_s) noexcept;

  HandEstimateSettings settings_;
  SampleNoise noise_;
  VelocityPersistence persistence_;
  Motion motion_ = Motion::Zero();
  Eigen::Matrix2d covariance_ = Eigen::Matrix2d::Zero();
  double surprise_m2_ = 0.0;        ///< recent mean square of the filter's innovations, per axis
  double process_m2_per_s3_ = 0.0;  ///< intensity of the hand's random acceleration
  SessionTime newest_{};            ///< time of the newest accepted sample
  SessionTime received_{};          ///< time of the newest sample, accepted or rejected
  Point<HapticBase> held_at_;       ///< position of the newest rejected sample
  double implausible_s_ = 0.0;
  double agree_s_ = 0.0;  ///< for how long the rejected samples have agreed with each other
  bool started_ = false;
  std::uint64_t refused_ = 0;
};

}  // namespace telepalp::tracking
