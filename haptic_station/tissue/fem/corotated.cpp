#include "haptic_station/tissue/fem/corotated.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

namespace telepalp::tissue {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A deformation that is not a number keeps stretches that are not numbers: of such a matrix Eigen's decomposition has
/// no values at all.
Corotated::Corotated(const Matrix3d& deformation, const Lame& material) noexcept
    : material_(material),
      u_(Matrix3d::Identity()),
      v_(Matrix3d::Identity()),
      stretch_(Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())) {
  Eigen::JacobiSVD<Matrix3d, Eigen::NoQRPreconditioner> svd;
  svd.compute(deformation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (svd.info() != Eigen::Success) return;
  u_ = svd.matrixU();
  v_ = svd.matrixV();
  stretch_ = svd.singularValues();
  if (u_.determinant() < 0.0) {
    u_.col(2) *= -1.0;
    stretch_.z() *= -1.0;
  }
  if (v_.determinant() < 0.0) {
    v_.col(2) *= -1.0;
    stretch_.z() *= -1.0;
  }
}

double Corotated::energy_J_per_m3() const noexcept {
  const double swollen = stretch_.prod() - 1.0;
  return material_.mu * (stretch_.array() - 1.0).square().sum() + 0.5 * material_.lambda * swollen * swollen;
}

Vector3d Corotated::others() const noexcept {
  return {stretch_[1] * stretch_[2], stretch_[2] * stretch_[0], stretch_[0] * stretch_[1]};
}

Matrix3d Corotated::stress_Pa() const noexcept {
  const double pressure = material_.lambda * (stretch_.prod() - 1.0);
  const Vector3d main = 2.0 * material_.mu * (stretch_.array() - 1.0).matrix() + pressure * others();
  return u_ * main.asDiagonal() * v_.transpose();
}

/// Of the nine directions in which F can change, three stretch it, three shear it and three turn it; in each pair of
/// axes, shearing and turning have an eigenvalue each (Stomakhin and others 2012; Smith, de Goes, Kim 2019).
void Corotated::prepare(Curvature curvature) noexcept {
  constexpr double kLeast = 1e-6;  // where two stretches sum to zero, the energy has a ridge
  const double pressure = material_.lambda * (stretch_.prod() - 1.0);
  const Vector3d product = others();
  main_ = material_.lambda * product * product.transpose();
  main_.diagonal().array() += 2.0 * material_.mu;
  for (int i = 0; i < 3; ++i)
    for (int j = i + 1; j < 3; ++j) {
      const double third = stretch_[3 - i - j];
      const double sum = std::max(kLeast, stretch_[i] + stretch_[j]);  // never negative: see the class
      double shear = 2.0 * material_.mu - pressure * third;
      double turn = 2.0 * material_.mu * (sum - 2.0) / sum + pressure * third;
      if (curvature == Curvature::Positive) {
        shear = std::max(0.0, shear);
        turn = std::max(0.0, turn);
      }
      main_(i, j) += pressure * third;
      main_(j, i) = main_(i, j);
      same_(i, j) = same_(j, i) = 0.5 * (shear + turn);
      cross_(i, j) = cross_(j, i) = 0.5 * (shear - turn);
    }
  if (curvature == Curvature::Exact) return;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> modes(main_);
  main_ = modes.eigenvectors() * modes.eigenvalues().cwiseMax(0.0).asDiagonal() * modes.eigenvectors().transpose();
}

Matrix3d Corotated::turned_block(const Vector3d& a, const Vector3d& b) const noexcept {
  Matrix3d block = main_.cwiseProduct(a * b.transpose()) + cross_.cwiseProduct(b * a.transpose());
  block.diagonal() += same_ * a.cwiseProduct(b);
  return block;
}

}  // namespace telepalp::tissue
