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

}  // namespace telepalp::effects
