#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "haptic_station/surface/depth/depth_field.h"

namespace telepalp::surface {

/// A patch of skin as first seen: surface points around its centre, the mark. The slopes of depth at these points make
/// a tangential motion (slide) of the patch visible in a depth image. Depth camera's frame, metres.
struct SkinPatch {
  struct Node {
    Eigen::Vector3d at;     ///< [m], depth camera's frame
    Eigen::Vector2d slope;  ///< derivative of depth by x and by y [m/m]
    Eigen::Vector2d from;   ///< offset of the node from the mark, in units of `radius_m`
  };
  double radius_m = 0.0;
  Eigen::Vector3d mark = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, towards the camera
  std::vector<Node> nodes;
  Eigen::Matrix2d slide_information = Eigen::Matrix2d::Zero();  ///< Fisher information [1/m2] for 1 m depth noise
};

/// The patch within `radius_m` of where the line through `point` [m] along `up` (unit) meets the surface; both in the
/// depth camera's frame. nullopt: a hole or a depth break at the mark, or fewer than 200 nodes.
[[nodiscard]] std::optional<SkinPatch> skin_patch(const DepthField& depth, const Intrinsics& camera,
                                                  const Eigen::Vector3d& point, const Eigen::Vector3d& up,
                                                  double radius_m);

}  // namespace telepalp::surface
