#include "haptic_station/effects/skin_law.h"

#include <cmath>

namespace telepalp::effects {
namespace {

double energy_along_J(const SkinLaw& law, double d) noexcept {
  return d * d * (law.constant_N_per_m / 2.0 + d * (law.slope_N_per_m2 / 3.0 + d * law.curve_N_per_m3 / 4.0));
}

}  // namespace

Eigen::Vector3d skin_force_N(const SkinLaw& law, const Eigen::Vector3d& d_m) noexcept {
  if (!law.by_axis) return -law.stiffness_N_per_m(d_m.norm()) * d_m;
  // |d_i|: as printed, eq. (7) turns negative for a negative component.
  return {-law.stiffness_N_per_m(std::abs(d_m.x())) * d_m.x(), -law.stiffness_N_per_m(std::abs(d_m.y())) * d_m.y(),
          -law.stiffness_N_per_m(std::abs(d_m.z())) * d_m.z()};
}

double skin_energy_J(const SkinLaw& law, const Eigen::Vector3d& d_m) noexcept {
  if (!law.by_axis) return energy_along_J(law, d_m.norm());
  return energy_along_J(law, std::abs(d_m.x())) + energy_along_J(law, std::abs(d_m.y())) +
         energy_along_J(law, std::abs(d_m.z()));
}

double skin_stiffest_N_per_m(const SkinLaw& law, double most_N) noexcept {
  double deepest_m = 0.2;
  if (law.stiffness_N_per_m(deepest_m) * deepest_m > most_N) {
    double shallow_m = 0.0;
    for (int i = 0; i < 40; ++i) {
      const double middle_m = 0.5 * (shallow_m + deepest_m);
      (law.stiffness_N_per_m(middle_m) * middle_m > most_N ? deepest_m : shallow_m) = middle_m;
    }
  }
  return law.constant_N_per_m + (2.0 * law.slope_N_per_m2 + 3.0 * law.curve_N_per_m3 * deepest_m) * deepest_m;
}

}  // namespace telepalp::effects
