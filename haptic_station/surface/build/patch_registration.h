#pragma once

#include "haptic_station/surface/build/skin_patch.h"

namespace telepalp::surface {

/// Motion of a patch from its first image to another: a slide along x and y of the camera, and a change of depth. The
/// fit lets the change of depth vary over the patch as a quadratic polynomial, as in breathing; PatchPose keeps only
/// the change at the mark, the patch's centre.
struct PatchPose {
  bool seen = false;  ///< at least half of the nodes within 20 mm of the mark (by weight) are measured and fit
  Eigen::Vector2d slide_m = Eigen::Vector2d::Zero();
  double deeper_m = 0.0;       ///< increase of the mark's depth along the optical axis
  double sigma_depth_m = 0.0;  ///< 1-sigma of `deeper_m`
  double sigma_slide_m = 0.0;  ///< 1-sigma of `slide_m` in its least certain direction
};

/// The residuals `m` [m] of the patch's nodes that the image measures: measured minus expected depth.
struct PatchResiduals {
  std::vector<double> m;
  std::vector<double> terms;    ///< eight per node: derivatives of its expected depth by the eight coefficients
  std::vector<char> in_middle;  ///< 1: the node is within 20 mm of the mark
  int middle_nodes = 0;         ///< number of nodes within 20 mm of the mark, measured or not
};

/// Weighted normal equations of a patch's eight coefficients: two of the slide, six of the change of depth.
struct PatchFit {
  double scale_m = 0.0;  ///< 1-sigma of the residuals, from the median of their magnitudes
  Eigen::Matrix<double, 8, 8> normal = Eigen::Matrix<double, 8, 8>::Identity() * 1e-6;
  Eigen::Matrix<double, 8, 1> by = Eigen::Matrix<double, 8, 1>::Zero();
  double middle_weight = 0.0;  ///< sum of the weights of the nodes within 20 mm of the mark
  double middle_m = 0.0;       ///< weighted mean of the residuals of these nodes
};

/// Finds the pose of a patch in an image by iteratively reweighted least squares with Tukey's weights, from the pose
/// `start`. The residuals at `start` are equal with and without a fitted slide, so they are computed once. Patch, image
/// and camera must outlive the search. Pure.
class PatchSearch {
 public:
  PatchSearch(const SkinPatch& patch, const DepthField& depth, const Intrinsics& camera, const PatchPose& start);

  /// The pose. With `slides` false, only the change of depth is fitted, and the slide stays that of `start`.
  [[nodiscard]] PatchPose found(bool slides) const;

 private:
  const SkinPatch& patch_;
  const DepthField& depth_;
  const Intrinsics& camera_;
  const PatchPose start_;
  PatchResiduals residuals_;  ///< at the start
  PatchFit fit_;              ///< of these residuals
};

}  // namespace telepalp::surface
