#pragma once

#include <Eigen/Core>

#include "haptic_station/effects/laws/spring.h"

namespace telepalp::effects {

/// Stiffness as a polynomial of the indentation: k(d) = constant + slope d + curve d^2, d in metres. Eq. (7) of paper
/// S1 (docs/sources.md) has constant 0 and slope = curve = alpha. A linear spring has only the constant. A measured
/// tissue uses all three. No coefficient is negative, so the force grows with depth.
struct SkinLaw {
  double constant_N_per_m = 0.0;
  double slope_N_per_m2 = 160.0 / (0.06 * 0.06 + 0.06);  ///< from S1 III.A: 160 N/m at 0.06 m
  double curve_N_per_m3 = 160.0 / (0.06 * 0.06 + 0.06);
  bool by_axis = false;  ///< false: one k(|d|) for all axes; true: k_i(|d_i|) for each axis i, as S1 prints

  [[nodiscard]] double stiffness_N_per_m(double distance_m) const noexcept {
    return constant_N_per_m + (slope_N_per_m2 + curve_N_per_m3 * distance_m) * distance_m;
  }
  /// This law with the share `left` of its stiffness.
  [[nodiscard]] SkinLaw weakened(double left) const noexcept {
    return {left * constant_N_per_m, left * slope_N_per_m2, left * curve_N_per_m3, by_axis};
  }
  /// Magnitude of the force of one spring at the indentation `distance_m`, and the derivative by this indentation.
  [[nodiscard]] Pull pull(double distance_m) const noexcept {
    return {stiffness_N_per_m(distance_m) * distance_m,
            constant_N_per_m + (2.0 * slope_N_per_m2 + 3.0 * curve_N_per_m3 * distance_m) * distance_m};
  }
};

/// The law of S1 eq. (7) with this `alpha` [N/m^2].
[[nodiscard]] constexpr SkinLaw paper_law(double alpha) noexcept {
  return {.constant_N_per_m = 0.0, .slope_N_per_m2 = alpha, .curve_N_per_m3 = alpha};
}
[[nodiscard]] constexpr SkinLaw linear_law(double stiffness_N_per_m) noexcept {
  return {.constant_N_per_m = stiffness_N_per_m, .slope_N_per_m2 = 0.0, .curve_N_per_m3 = 0.0};
}

/// The alpha with which S1 eq. (7) gives `stiffness_N_per_m` at a depth of `distance_m`.
[[nodiscard]] constexpr double alpha_for(double stiffness_N_per_m, double distance_m) noexcept {
  return stiffness_N_per_m / (distance_m * distance_m + distance_m);
}

/// Restoring force [N] for the indentation vector `d_m` of S1 eq. (8): F = -K(d) d (eq. 6, whose sign S1 does not
/// state). `relaxed_m`: see LinearSpring. The skin is one spring along `d_m`, or one for each axis.
[[nodiscard]] Eigen::Vector3d skin_force_N(const SkinLaw& law, const Eigen::Vector3d& d_m,
                                           double relaxed_m = 0.0) noexcept;
/// The magnitudes of the skin's springs at `d_m`.
[[nodiscard]] Pull skin_pull(const SkinLaw& law, const Eigen::Vector3d& d_m, double relaxed_m) noexcept;

/// Energy [J] that the skin stores at `d_m`: the integral of -skin_force_N over the indentation. `relaxed_m`: see
/// LinearSpring.
[[nodiscard]] double skin_energy_J(const SkinLaw& law, const Eigen::Vector3d& d_m, double relaxed_m = 0.0) noexcept;

/// The largest slope of force over depth [N/m] up to the depth where the force reaches `most_N`, or up to 0.2 m if it
/// does not.
[[nodiscard]] double skin_stiffest_N_per_m(const SkinLaw& law, double most_N) noexcept;

}  // namespace telepalp::effects
