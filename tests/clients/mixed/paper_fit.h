#pragma once

#include <Eigen/Dense>

namespace telepalp::mixed {

/// Two readings of the fit in paper S3. Tests compare them with Eigen::umeyama(), which telepalp uses in its place.
enum class PaperFit {
  AsPrinted,  ///< S3 eq. (1): translation from the means alone, an affine map about the origin, its rotation
  Centred,    ///< the affine map of the points about their means, then that map's rotation by polar decomposition
};

/// The motion `haptic = R * world + T` of paper S3 (docs/sources.md) 4.2. `haptic`, `world`: 3 x N [m]. The rotation
/// may be improper (determinant -1): an affine map is undetermined across a plane that holds all points.
[[nodiscard]] inline Eigen::Affine3d paper_fit(const Eigen::Matrix3Xd& haptic, const Eigen::Matrix3Xd& world,
                                               PaperFit how) {
  const Eigen::Vector3d haptic_mean = haptic.rowwise().mean();
  const Eigen::Vector3d world_mean = world.rowwise().mean();
  const bool printed = how == PaperFit::AsPrinted;
  const Eigen::Vector3d translation = haptic_mean - world_mean;
  const Eigen::Matrix3Xd to = haptic.colwise() - (printed ? translation : haptic_mean);
  const Eigen::Matrix3Xd from = printed ? world : Eigen::Matrix3Xd(world.colwise() - world_mean);
  const Eigen::Matrix3d affine =
      from.transpose().colPivHouseholderQr().solve(Eigen::MatrixXd(to.transpose())).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(affine, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Affine3d fit = Eigen::Affine3d::Identity();
  fit.linear() = svd.matrixU() * svd.matrixV().transpose();
  fit.translation() = printed ? translation : Eigen::Vector3d(haptic_mean - fit.linear() * world_mean);
  return fit;
}

}  // namespace telepalp::mixed
