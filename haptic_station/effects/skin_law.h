#pragma once

#include <Eigen/Core>

namespace telepalp::effects {

/// S1 eq. (7) as a law of the distance: k(d) = alpha (d^2 + d), d in metres, k in N/m.
struct SkinLaw {
  double alpha = 160.0 / (0.06 * 0.06 + 0.06);  ///< the stiffness that S1 III.A states: 160 N/m at 0.06 m
  bool by_axis = false;                         ///< false: one k(|d|) for all directions. true: k_i(|d_i|), as printed

  [[nodiscard]] double stiffness_N_per_m(double distance_m) const noexcept {
    return alpha * (distance_m * distance_m + distance_m);
  }
};

/// alpha for which k(`distance_m`) is `stiffness_N_per_m`.
[[nodiscard]] constexpr double alpha_for(double stiffness_N_per_m, double distance_m) noexcept {
  return stiffness_N_per_m / (distance_m * distance_m + distance_m);
}

/// Restoring force [N] for the indentation vector `d_m` of S1 eq. (8): F = -K(d) d (eq. 6; the paper leaves the sign
/// to the reader).
[[nodiscard]] Eigen::Vector3d skin_force_N(const SkinLaw& law, const Eigen::Vector3d& d_m) noexcept;

/// Energy [J] that the skin stores at `d_m`: the integral of skin_force_N's opposite.
[[nodiscard]] double skin_energy_J(const SkinLaw& law, const Eigen::Vector3d& d_m) noexcept;

}  // namespace telepalp::effects
