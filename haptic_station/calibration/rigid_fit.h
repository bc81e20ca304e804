#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// The same place seen by both devices, each perhaps several times.
struct PointPair {
  std::vector<Eigen::Vector3d> from_m;  ///< repeats, in the source frame
  std::vector<Eigen::Vector3d> to_m;    ///< repeats, in the target frame
};

struct RigidFit {
  Eigen::Isometry3d to_from = Eigen::Isometry3d::Identity();
  double rms_residual_m = 0.0;
  std::vector<double> residuals_m;  ///< by pair
  double repeat_sigma_m = 0.0;      ///< spread of the repeats, by axis: what the residual cannot be below
};

/// The rigid motion that maps the pairs' means best (S3 section 4.2: centroids, least squares, polar decomposition).
/// Error: fewer than three pairs, collinear or coincident points (with their rank), mirrored frames, numbers that are
/// not finite.
[[nodiscard]] Result<RigidFit> fit_rigid(std::span<const PointPair> pairs);

/// S1 eq. (2) to (4): the tracker looks down on the device, R = diag(1, -1, -1), and the hand lies on the end-effector
/// where both are recorded once.
[[nodiscard]] Transform<HapticBase, HandTracker> haptic_from_tracker_at(const Point<HandTracker>& hand,
                                                                        const Point<HapticBase>& device) noexcept;

}  // namespace telepalp::calibration
