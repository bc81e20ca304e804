#pragma once

#include <Eigen/Dense>

#include "haptic_station/surface/build/skin_patch.h"

namespace telepalp::surface {

/// Motion of a patch as coefficients: slide along x and y [m], then the change of depth [m] as a polynomial 1, x, y,
/// x², xy, y² of the position in units of the patch's radius.
using PatchCoefficients = Eigen::Matrix<double, 8, 1>;

/// Derivatives of a node's expected depth by the eight coefficients.
[[nodiscard]] inline PatchCoefficients terms_of(const SkinPatch::Node& node) {
  const double x = node.from.x();
  const double y = node.from.y();
  PatchCoefficients terms;
  terms << -node.slope.x(), -node.slope.y(), 1.0, x, y, x * x, x * y, y * y;
  return terms;
}

/// Information matrix of the slide, with the change of depth marginalised out (Schur complement of `normal`).
[[nodiscard]] inline Eigen::Matrix2d slide_information(const Eigen::Matrix<double, 8, 8>& normal) {
  const Eigen::Matrix<double, 6, 6> rise = normal.bottomRightCorner<6, 6>();
  return normal.topLeftCorner<2, 2>() -
         normal.topRightCorner<2, 6>() * rise.ldlt().solve(normal.bottomLeftCorner<6, 2>());
}

[[nodiscard]] inline Eigen::Vector2d pixel_of(const Intrinsics& camera, const Eigen::Vector3d& at) {
  return {camera.fx * at.x() / at.z() + camera.cx, camera.fy * at.y() / at.z() + camera.cy};
}

}  // namespace telepalp::surface
