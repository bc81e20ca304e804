#pragma once

#include <Eigen/Core>
#include <array>

namespace telepalp::capture {

/// The place of a colleague's hand over the patient at one instant, in the depth camera's frame. The palm faces away
/// from the camera, along its optical axis.
struct ColleagueHand {
  Eigen::Vector3d under_palm_m = Eigen::Vector3d::Zero();  ///< middle of the palm's underside
  double heading_rad = 0.0;       ///< direction of the fingers in the image, from right to down
  double arm_rise_rad = 0.35;     ///< angle by which the forearm rises towards the camera, away from the hand
  std::array<double, 5> lifts{};  ///< angles by which thumb and fingers are lifted off the palm's plane [rad]
};

}  // namespace telepalp::capture
