#pragma once

#include <span>

#include "haptic_station/calibration/residuals.h"
#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// One measurement with the hand lying on the probe: the hand's pose from the tracker and the probe's pose from the
/// device.
struct HandOnProbe {
  Eigen::Isometry3d tracker_from_hand = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d haptic_from_probe = Eigen::Isometry3d::Identity();
};

struct ProbeCalibration {
  Eigen::Isometry3d haptic_from_tracker = Eigen::Isometry3d::Identity();
  /// One per pose: distance between the hand's position from the device (haptic_from_probe * probe_from_hand) and from
  /// the tracker (haptic_from_tracker * tracker_from_hand), both in the haptic base's frame.
  Residuals residuals;
  std::vector<double> angles_rad;  ///< one per pose: angle between the hand's attitudes from device and tracker
};

struct ProbeSettings {
  double furthest_m = 0.03;  ///< largest residual that a pose may have
};

/// Finds the tracker's pose in the haptic base's frame from poses of a hand that lies on the probe in the known pose
/// `probe_from_hand` (paper S2, docs/sources.md, II.C). The tracker may be worn on the head or fixed. One pose is
/// enough; several are averaged: chordal mean of the rotations, mean of the hand's positions. Error: no pose, a number
/// that is not finite or beyond 10 m, a matrix that is not a rotation (mirrored or scaled), rotations whose mean is
/// undefined, or a pose whose residual or angle exceeds `settings`.
[[nodiscard]] Result<ProbeCalibration> calibrate_hand_on_probe(std::span<const HandOnProbe> poses,
                                                               const Eigen::Isometry3d& probe_from_hand,
                                                               const ProbeSettings& settings = {});

}  // namespace telepalp::calibration
