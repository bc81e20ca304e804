#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "haptic_station/surface/depth/depth_field.h"

namespace telepalp::surface {

/// A patch of skin as it was seen first: points around a mark, with the slopes of depth that tell a slide.
struct SkinPatch {
  struct Node {
    Eigen::Vector3d at;     ///< [m], depth camera's frame
    Eigen::Vector2d slope;  ///< of depth over x and y
    Eigen::Vector2d from;   ///< from the mark, in units of the patch's radius
  };
  Eigen::Vector3d mark = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, towards the camera
  std::vector<Node> nodes;
  Eigen::Matrix2d slide_information = Eigen::Matrix2d::Zero();  ///< of a slide, for a unit variance of the nodes
};

/// The patch around the crossing of `line` with the surface. nullopt: too little is measured there.
[[nodiscard]] std::optional<SkinPatch> skin_patch(const DepthField& depth, const Intrinsics& camera,
                                                  const Eigen::Vector3d& point, const Eigen::Vector3d& up);

/// How a patch lies in another image: slid by `slide_m` along x and y of the camera, with a rise that varies smoothly
/// (as a polynomial of the second degree) over the patch, as breathing makes it.
struct PatchPose {
  bool seen = false;  ///< the patch's middle is measured
  Eigen::Vector2d slide_m = Eigen::Vector2d::Zero();
  double deeper_m = 0.0;       ///< of the mark, along the optical axis
  double sigma_depth_m = 0.0;  ///< 1-sigma of `deeper_m`
  double sigma_slide_m = 0.0;  ///< 1-sigma of `slide_m` in its least certain direction
};

/// Finds `patch` in `depth`, from `start` on, by iterated least squares with Tukey's weights. With `slides` false the
/// slide stays as in `start`. A pure function.
[[nodiscard]] PatchPose registered(const SkinPatch& patch, const DepthField& depth, const Intrinsics& camera,
                                   const PatchPose& start, bool slides);

}  // namespace telepalp::surface
