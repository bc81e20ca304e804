#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::capture {

/// The place of a colleague's hand over the patient at one instant, in the depth camera's frame. The palm faces away
/// from the camera, along its optical axis.
struct ColleagueHand {
  Eigen::Vector3d under_palm_m = Eigen::Vector3d::Zero();  ///< middle of the palm's underside
  double heading_rad = 0.0;       ///< direction of the fingers in the image, from right to down
  double arm_rise_rad = 0.35;     ///< angle by which the forearm rises towards the camera, away from the hand
  std::array<double, 5> lifts{};  ///< angles by which thumb and fingers are lifted off the palm's plane [rad]
};

/// A line that a sphere sweeps.
struct Capsule {
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d to_m = Eigen::Vector3d::Zero();
  double radius_m = 0.0;
};

/// The hand as capsules of an adult's measures: four rays of the palm (26 mm thick), four fingers and a thumb (16 to 18
/// mm thick), and a forearm of 0.7 m, which grows from 52 to 76 mm and leaves the image.
[[nodiscard]] std::vector<Capsule> capsules_of(const ColleagueHand& hand);

/// Draws `capsules` over `depth_m`, the depth [m] of each pixel, row by row: at each pixel, the nearer one counts.
void draw_over(const std::vector<Capsule>& capsules, const Intrinsics& camera, std::vector<float>& depth_m);

}  // namespace telepalp::capture
