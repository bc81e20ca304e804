#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "haptic_station/calibration/residuals.h"
#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// One place, measured in both frames [m]. Pairs with the same `place` are repeats of one place.
struct PointPair {
  int place = 0;
  Eigen::Vector3d to;
  Eigen::Vector3d from;
};

/// How the rotation is found.
enum class RotationBy {
  Covariance,   ///< SVD of the cross-covariance (Kabsch): the least-squares rotation itself
  AffinePolar,  ///< S3 4.2, eq. (1): least-squares affine map, then its polar rotation. The reference; needs rank 3
};

struct RegistrationSettings {
  RotationBy rotation_by = RotationBy::Covariance;
  double least_spread_m = 0.005;     ///< of the places along a direction that is to count (standard deviation)
  double least_spread_share = 0.02;  ///< of the widest direction
  double largest_rms_share = 0.1;    ///< of the widest direction: beyond, the pairs do not belong together
};

/// A rigid motion and how well it fits.
struct Registration {
  Eigen::Isometry3d to_from_from = Eigen::Isometry3d::Identity();
  Residuals residuals;  ///< one for each pair, as given
  int rank = 0;         ///< directions that the places span: 2 (in one plane) or 3
};

/// The rigid motion that brings `from` onto `to` with the least squared distance. Repeats are averaged first, so that
/// each place counts once.
/// Error: fewer than three places, numbers that are not finite or beyond 10 m, places on a line (with their rank),
/// mirrored sets, sets of different size (metres against millimetres), pairs that do not belong together.
/// Source: S3 4.2 (centroids, least squares, nearest rotation); unlike it we take the translation after the rotation,
/// since T as printed holds only if the frames' axes agree.
[[nodiscard]] Result<Registration> register_points(std::span<const PointPair> pairs,
                                                   const RegistrationSettings& settings = {});

}  // namespace telepalp::calibration
