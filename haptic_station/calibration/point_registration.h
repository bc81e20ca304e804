#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <vector>

#include "haptic_station/calibration/residuals.h"
#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// A point measured in two frames [m]. Pairs with equal `place` are repeated measurements of one point.
struct PointPair {
  int place = 0;
  Eigen::Vector3d to;
  Eigen::Vector3d from;
};

inline constexpr std::size_t kMostPairs = 100'000;  ///< of a registration, and of a file

/// The method that estimates the rotation.
enum class RotationBy {
  Covariance,  ///< SVD of the cross-covariance (Kabsch): the least-squares rotation
  /// Paper S3 (docs/sources.md) 4.2, eq. (1): rotation of the polar decomposition of the least-squares affine map;
  /// needs rank 3.
  AffinePolar,
};

struct RegistrationSettings {
  RotationBy rotation_by = RotationBy::Covariance;
};

/// A rigid motion and how well it fits.
struct Registration {
  Eigen::Isometry3d to_from_from = Eigen::Isometry3d::Identity();
  Residuals residuals;  ///< one for each pair, in the order of the input
  int rank = 0;         ///< dimensions that the points span: 2 (a plane) or 3
};

/// The rigid motion from `from` to `to` with the least sum of squared distances. Pairs with equal `place` are
/// averaged first, so that each point has equal weight. Error: fewer than three points, over 100 000 pairs, a number
/// that is not finite or beyond 10 m, points on a line (reported with their rank), points in a plane with
/// AffinePolar, mirrored sets, sets of different scale (metres against millimetres), or an rms residual above
/// a tenth of the widest axis's standard deviation. Source: paper S3 4.2 (centroids, least squares, nearest rotation).
/// Unlike S3, the translation is computed after the rotation, because the translation T as printed in S3 is correct
/// only if the axes of both frames are parallel.
[[nodiscard]] Result<Registration> register_points(std::span<const PointPair> pairs,
                                                   const RegistrationSettings& settings = {});

}  // namespace telepalp::calibration
