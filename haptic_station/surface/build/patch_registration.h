#pragma once

#include "haptic_station/surface/build/skin_patch.h"

namespace telepalp::surface {

/// Motion of a patch from its first image to another: a slide along x and y of the camera, and a change of depth that
/// varies over the patch as a polynomial of the second degree, as in breathing.
struct PatchPose {
  bool seen = false;  ///< the patch's middle is measured
  Eigen::Vector2d slide_m = Eigen::Vector2d::Zero();
  double deeper_m = 0.0;       ///< increase of the mark's depth along the optical axis
  double sigma_depth_m = 0.0;  ///< 1-sigma of `deeper_m`
  double sigma_slide_m = 0.0;  ///< 1-sigma of `slide_m` in its least certain direction
};

/// One node's residual: measured minus expected depth.
struct PatchResiduals {
  std::vector<double> m;
  std::vector<double> terms;    ///< eight a node: the derivatives of its expected depth by the coefficients
  std::vector<char> in_middle;  ///< 1: the node is near the mark
  int middle_nodes = 0;         ///< of the patch, measured or not
};

/// Weighted normal equations of a patch's eight coefficients.
struct PatchFit {
  double scale_m = 0.0;  ///< 1-sigma of the residuals, from their median
  Eigen::Matrix<double, 8, 8> normal = Eigen::Matrix<double, 8, 8>::Identity() * 1e-6;
  Eigen::Matrix<double, 8, 1> by = Eigen::Matrix<double, 8, 1>::Zero();
  double middle_weight = 0.0;
  double middle_m = 0.0;  ///< mean residual in the patch's middle
};

/// Finds a patch in an image by iterated least squares with Tukey's weights, starting at a pose. The residuals
/// at the start are the same whether the patch may slide or not, so they are computed once. Patch and image must outlive
/// the search. Pure.
class PatchSearch {
 public:
  PatchSearch(const SkinPatch& patch, const DepthField& depth, const Intrinsics& camera, const PatchPose& start);

  /// With `slides` false, only the depth is fitted, and the slide stays as at the start.
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
