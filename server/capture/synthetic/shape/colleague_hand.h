#pragma once

#include <Eigen/Core>
#include <vector>

#include "proto/words/rgbd_frame.h"
#include "server/capture/synthetic/motion/colleague_pose.h"

namespace telepalp::capture {

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
