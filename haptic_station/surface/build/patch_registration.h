#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "haptic_station/surface/depth/depth_field.h"

namespace telepalp::surface {

/// A patch of skin as it was first seen: points around a mark. A sideways slide of the patch is found by their slopes.
struct SkinPatch {
  struct Node {
    Eigen::Vector3d at;     ///< [m], depth camera's frame
    Eigen::Vector2d slope;  ///< derivative of depth by x and by y
    Eigen::Vector2d from;   ///< offset of the node from the mark, in units of the patch's radius
  };
  Eigen::Vector3d mark = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, towards the camera
  std::vector<Node> nodes;
  Eigen::Matrix2d slide_information = Eigen::Matrix2d::Zero();  ///< Fisher information on a slide at 1 m depth noise
};

/// The patch where the line through `point` along `up` meets the surface. nullopt: too few pixels are measured there.
[[nodiscard]] std::optional<SkinPatch> skin_patch(const DepthField& depth, const Intrinsics& camera,
                                                  const Eigen::Vector3d& point, const Eigen::Vector3d& up);

/// Motion of a patch from its first image to another: a slide along x and y of the camera, and a change of depth that
/// varies over the patch as a polynomial of the second degree, as in breathing.
struct PatchPose {
  bool seen = false;  ///< the patch's middle is measured
  Eigen::Vector2d slide_m = Eigen::Vector2d::Zero();
  double deeper_m = 0.0;       ///< increase of the mark's depth along the optical axis
  double sigma_depth_m = 0.0;  ///< 1-sigma of `deeper_m`
  double sigma_slide_m = 0.0;  ///< 1-sigma of `slide_m` in its least certain direction
};

/// Finds `patch` in `depth` by iterated least squares with Tukey's weights, starting at `start`. With `slides` false,
/// only the depth is fitted and the slide stays as in `start`. A pure function.
[[nodiscard]] PatchPose registered(const SkinPatch& patch, const DepthField& depth, const Intrinsics& camera,
                                   const PatchPose& start, bool slides);

}  // namespace telepalp::surface
