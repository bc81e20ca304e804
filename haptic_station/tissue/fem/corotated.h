#pragma once

#include <Eigen/Core>

namespace telepalp::tissue {

/// Lamé's constants of an isotropic material [Pa].
struct Lame {
  double mu = 0.0;
  double lambda = 0.0;
};
[[nodiscard]] constexpr Lame lame(double young_Pa, double poisson) noexcept {
  return {.mu = young_Pa / (2.0 * (1.0 + poisson)),
          .lambda = young_Pa * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))};
}

/// Whether a second derivative may have negative eigenvalues. Positive: they are replaced by zero, so that Newton's
/// step descends where the energy curves downwards, as in a compressed or inverted element.
enum class Curvature { Exact, Positive };

/// The corotational elasticity of paper S3 (docs/sources.md), 8.4, at one deformation gradient F, as an energy:
///
///   Psi(F) = mu |F - R|^2 + lambda / 2 (det F - 1)^2,   R = the rotation nearest to F.
///
/// Its stress P = 2 mu (F - R) + lambda (det F - 1) cof F is the exact gradient of Psi: R is where tr(R^T F) is
/// greatest, so its own change adds nothing. Warped stiffness (Mueller and Gross 2004) has no energy, and ledgers drift
/// with it.
///
/// The linear corotational law has tr(R^T F - I)^2 in place of (det F - 1)^2, to which it is equal for small strains.
/// There the energy has valleys with an edge, in which inverted elements stay. The "fixed" corotational energy with det
/// F (Stomakhin and others 2012) has no such valley; a prism of some elements still has false minima
/// (PrismTouch::move()).
///
/// R comes from the singular value decomposition with rotations on both sides, F = U diag(s) V^T, R = U V^T: an
/// inverted element has a negative s3 of least magnitude (Irving, Teran, Fedkiw 2004), so no two stretches have a
/// negative sum, and the force turns the element right side out. At det F = 0 this decomposition has no exception. R is
/// a function of F alone, so that Psi is one, too; a rotation that is remembered from before would not be.
class Corotated {
 public:
  Corotated(const Eigen::Matrix3d& deformation, const Lame& material) noexcept;

  [[nodiscard]] double energy_J_per_m3() const noexcept;
  [[nodiscard]] Eigen::Matrix3d stress_Pa() const noexcept;  ///< first Piola-Kirchhoff

  /// The second derivative between two nodes, whose shape functions have the gradients `a` and `b` [1/m]: how the
  /// stress times `a` changes when the node of `b` moves [N/m^4]. Needs prepare().
  [[nodiscard]] Eigen::Matrix3d block(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const noexcept {
    return u_ * turned_block(v_.transpose() * a, v_.transpose() * b) * u_.transpose();
  }
  /// block() in the axes of U, for gradients in the axes of V.
  [[nodiscard]] Eigen::Matrix3d turned_block(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const noexcept;
  void prepare(Curvature curvature) noexcept;

  [[nodiscard]] const Eigen::Matrix3d& u() const noexcept { return u_; }
  [[nodiscard]] const Eigen::Matrix3d& v() const noexcept { return v_; }

 private:
  /// For each stretch, the product of the other two: the derivative of det F by it.
  [[nodiscard]] Eigen::Vector3d others() const noexcept;

  Lame material_;
  Eigen::Matrix3d u_;
  Eigen::Matrix3d v_;
  Eigen::Vector3d stretch_;
  Eigen::Matrix3d main_ = Eigen::Matrix3d::Zero();   ///< (i, j): derivative of P_ii by F_jj, in the axes of U and V
  Eigen::Matrix3d same_ = Eigen::Matrix3d::Zero();   ///< (i, j): derivative of P_ij by F_ij
  Eigen::Matrix3d cross_ = Eigen::Matrix3d::Zero();  ///< (i, j): derivative of P_ij by F_ji
};

}  // namespace telepalp::tissue
