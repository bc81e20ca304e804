#pragma once

#include <span>

#include "haptic_station/calibration/residuals.h"
#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// The hand lying on the probe: its pose as the tracker tells it, and the probe's as the device tells it.
struct HandOnProbe {
  Eigen::Isometry3d tracker_from_hand = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d haptic_from_probe = Eigen::Isometry3d::Identity();
};

struct ProbeCalibration {
  Eigen::Isometry3d haptic_from_tracker = Eigen::Isometry3d::Identity();
  Residuals residuals;             ///< of each pose's translation, at the probe
  std::vector<double> angles_rad;  ///< of each pose's rotation from the mean
};

struct ProbeSettings {
  double furthest_m = 0.03;      ///< a pose from the mean
  double furthest_rad = 0.2618;  ///< 15 degrees
};

/// S2 II.C: from poses of a hand that lies on the probe in the known pose `probe_from_hand`, where the tracker (worn
/// on the head, or fixed) stands in the haptic base. One pose is enough; repeats are averaged (chordal mean of the
/// rotations, mean of the hand's place). The tracker is whatever frame the hand's pose is told in.
/// Error: no pose, numbers that are not finite, a matrix that is no rotation (mirrored, scaled), poses that disagree.
[[nodiscard]] Result<ProbeCalibration> calibrate_hand_on_probe(std::span<const HandOnProbe> poses,
                                                               const Eigen::Isometry3d& probe_from_hand,
                                                               const ProbeSettings& settings = {});

}  // namespace telepalp::calibration
