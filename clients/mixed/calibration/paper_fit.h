#pragma once

#include <Eigen/Geometry>

namespace telepalp::mixed {

/// How the rigid motion is estimated, for comparison with Eigen::umeyama(), which telepalp uses.
enum class PaperFit {
  AsPrinted,  ///< S3 eq. (1): translation from the means alone, an affine map about the origin, its rotation
  Centred,    ///< the affine map of the points about their means, then that map's rotation by polar decomposition
};

/// The motion `haptic = R * world + T` of paper S3 (docs/sources.md) 4.2. `haptic`, `world`: 3 x N [m]. The rotation
/// may be improper (determinant -1): an affine map is undetermined across a plane that holds all points.
[[nodiscard]] Eigen::Affine3d paper_fit(const Eigen::Matrix3Xd& haptic, const Eigen::Matrix3Xd& world, PaperFit how);

}  // namespace telepalp::mixed
