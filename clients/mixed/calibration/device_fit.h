#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "clients/mixed/calibration/gimbal_error.h"
#include "clients/mixed/device/device_model.h"
#include "clients/mixed/view/view.h"
#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::mixed {

/// The doctor has placed the handle's tip on a ring that the display shows, and has pressed the button.
struct Click {
  int place = 0;                     ///< clicks with equal `place` are repeats at one ring
  Point<World> ring;                 ///< where the display showed it
  std::vector<double> readings_rad;  ///< joint angles as the device's encoders report them
};

/// What is fitted besides the rigid motion.
enum class GimbalFit {
  Fitted,   ///< the gimbal's error, held small by kGimbalDeviations_rad
  Ignored,  ///< nothing: the gimbal's encoders are taken as exact, as in paper S3
};

/// Where the device stands in the world, and how well the clicks agree with it.
struct DeviceFit {
  Transform<World, HapticBase> world_from_haptic;
  GimbalError gimbal;
  double rms_m = 0.0;        ///< root mean square of the distances between tip and ring
  double mean_m = 0.0;       ///< mean of the distances
  double deviation_m = 0.0;  ///< standard deviation of the distances
  double largest_m = 0.0;
  std::size_t worst = 0;  ///< the click with the largest distance
  /// Covariance of the pose's error: rotation vector [rad] about `centre`, then translation [m], in the world's frame.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  Point<World> centre;  ///< mean of the rings
};

/// Standard deviation of a click's error on each axis, from the 1.35 ± 0.58 mm of paper S3, 4.2.
inline constexpr double kClickDeviation_m = 0.00085;
/// Standard deviations of the prior on the coefficients of GimbalError: of the half period, then of the whole period.
/// The maker's ±5 % of the range is taken as the amplitude of the whole period. The half period gives the error a mean
/// other than zero, which is expected to be small.
inline constexpr std::array kGimbalDeviations_rad{0.01, 0.1};
inline constexpr double kLargestClickRms_m = 0.01;  ///< with a larger rms the clicks contradict each other

/// Fits the device's pose, by Kabsch on centred points, then refines it together with the gimbal's error by
/// Gauss-Newton with the prior that the error is small. Error: fewer than three places, places at one point or on a
/// line, a click without one angle for each joint or with a number that is not finite, or an rms above
/// kLargestClickRms_m.
[[nodiscard]] Result<DeviceFit> fit_device(const DeviceModel& model, std::span<const Click> clicks,
                                           GimbalFit gimbal = GimbalFit::Fitted);

/// The standard deviation of the world position of a point that is fixed to the base: of one axis, as root mean square
/// of the three [m]. The covariance of the fit gives it.
[[nodiscard]] double deviation_at_m(const DeviceFit& fit, const Point<World>& point) noexcept;

/// The fit in a sentence, with the click that misses its ring most.
[[nodiscard]] std::string in_words(const DeviceFit& fit, std::span<const Click> clicks);

}  // namespace telepalp::mixed
