#pragma once

#include <Eigen/Core>

namespace telepalp::effects {

/// Stiffness as a polynomial of the indentation: k(d) = constant + slope d + curve d^2, d in metres.
/// S1 eq. (7) is constant 0 and slope = curve = alpha; a linear spring is constant alone; a tissue's curve uses all
/// three. None is negative, so the force grows with depth.
struct SkinLaw {
  double constant_N_per_m = 0.0;
  double slope_N_per_m2 = 160.0 / (0.06 * 0.06 + 0.06);  ///< S1 III.A states 160 N/m at 0.06 m
  double curve_N_per_m3 = 160.0 / (0.06 * 0.06 + 0.06);
  bool by_axis = false;  ///< false: one k(|d|) for all directions. true: k_i(|d_i|), as printed

  [[nodiscard]] double stiffness_N_per_m(double distance_m) const noexcept {
    return constant_N_per_m + (slope_N_per_m2 + curve_N_per_m3 * distance_m) * distance_m;
  }
};

/// S1 eq. (7) with its alpha.
[[nodiscard]] constexpr SkinLaw paper_law(double alpha) noexcept {
  return {.constant_N_per_m = 0.0, .slope_N_per_m2 = alpha, .curve_N_per_m3 = alpha};
}
[[nodiscard]] constexpr SkinLaw linear_law(double stiffness_N_per_m) noexcept {
  return {.constant_N_per_m = stiffness_N_per_m, .slope_N_per_m2 = 0.0, .curve_N_per_m3 = 0.0};
}

/// alpha for which S1's k(`distance_m`) is `stiffness_N_per_m`.
[[nodiscard]] constexpr double alpha_for(double stiffness_N_per_m, double distance_m) noexcept {
  return stiffness_N_per_m / (distance_m * distance_m + distance_m);
}

/// Restoring force [N] for the indentation vector `d_m` of S1 eq. (8): F = -K(d) d (eq. 6; the paper leaves the sign
/// to the reader).
[[nodiscard]] Eigen::Vector3d skin_force_N(const SkinLaw& law, const Eigen::Vector3d& d_m) noexcept;

/// Energy [J] that the skin stores at `d_m`: the integral of skin_force_N's opposite.
[[nodiscard]] double skin_energy_J(const SkinLaw& law, const Eigen::Vector3d& d_m) noexcept;

/// Slope of force over depth [N/m] where the force reaches `most_N`, or at 0.2 m: the skin is nowhere stiffer before.
[[nodiscard]] double skin_stiffest_N_per_m(const SkinLaw& law, double most_N) noexcept;

}  // namespace telepalp::effects
