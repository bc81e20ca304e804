#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "haptic_station/surface/depth/depth_field.h"

namespace telepalp::surface {

/// A patch of skin as first seen: points around a mark, which is its centre. Their slopes make a tangential motion
/// (slide) of the patch visible in depth.
struct SkinPatch {
  struct Node {
    Eigen::Vector3d at;     ///< [m], depth camera's frame
    Eigen::Vector2d slope;  ///< derivative of depth by x and by y
    Eigen::Vector2d from;   ///< offset of the node from the mark, in units of kPatchRadius_m (patch_terms.h)
  };
  Eigen::Vector3d mark = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, towards the camera
  std::vector<Node> nodes;
  Eigen::Matrix2d slide_information = Eigen::Matrix2d::Zero();  ///< Fisher information on a slide; depth noise: 1 m
};

/// The patch where the line through `point` [m] along `up` (unit) meets the surface; both in the depth camera's frame.
/// nullopt: too few pixels are measured there, or depth breaks off.
[[nodiscard]] std::optional<SkinPatch> skin_patch(const DepthField& depth, const Intrinsics& camera,
                                                  const Eigen::Vector3d& point, const Eigen::Vector3d& up);

}  // namespace telepalp::surface
