#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "haptic_station/tracking/hand_estimate.h"

namespace telepalp::tracking {

/// The hand's attitude (paper S1, docs/sources.md, eq. 1), predicted from samples at about 100 Hz. The rotations from
/// sample to sample, as rotation vectors in the hand's axes, add up to a path. HandEstimate, the filter of the
/// position, filters this path, with radians in place of metres, and so learns the noise, the angular velocity and the
/// persistence of the angular velocity. No allocation. Owner: haptic thread.
class AttitudeEstimate {
 public:
  AttitudeEstimate() noexcept;

  /// Adds a sample: the rotation from the hand's axes (hand_axes.h) to the haptic base's frame. The quaternion need not
  /// be normalised; one shorter than 0.1 counts as not finite.
  Taken update(SessionTime at, const Eigen::Quaterniond& attitude) noexcept;
  /// Discards all samples.
  void forget() noexcept;
  /// The predicted attitude at `now`, as in update(); nullopt: no sample was accepted in the last second.
  [[nodiscard]] std::optional<Eigen::Quaterniond> predict(SessionTime now) const noexcept;

 private:
  HandEstimate path_;  ///< in radians
  Eigen::Quaterniond newest_ = Eigen::Quaterniond::Identity();
  Eigen::Vector3d turned_rad_ = Eigen::Vector3d::Zero();  ///< the path's value at the newest sample
  bool started_ = false;
};

}  // namespace telepalp::tracking
