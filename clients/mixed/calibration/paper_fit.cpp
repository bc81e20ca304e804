#include "clients/mixed/calibration/paper_fit.h"

#include <Eigen/Dense>

namespace telepalp::mixed {

Eigen::Affine3d paper_fit(const Eigen::Matrix3Xd& haptic, const Eigen::Matrix3Xd& world, PaperFit how) {
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
