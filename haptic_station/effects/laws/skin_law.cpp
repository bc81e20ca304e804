#include "haptic_station/effects/laws/skin_law.h"

#include <algorithm>
#include <cmath>

namespace telepalp::effects {
namespace {

double energy_along_J(const SkinLaw& law, double d) noexcept {
  return d * d * (law.constant_N_per_m / 2.0 + d * (law.slope_N_per_m2 / 3.0 + d * law.curve_N_per_m3 / 4.0));
}

/// Energy of one relaxed spring at the depth `d`.
double relaxed_energy_J(const SkinLaw& law, double d, double relaxed_m) noexcept {
  const double left_m = std::max(0.0, d - relaxed_m);
  return energy_along_J(law, left_m) + relaxed_m * law.pull(left_m).N;
}

/// Force of one relaxed spring at the signed depth `d_m`.
double relaxed_force_N(const SkinLaw& law, double d_m, double relaxed_m) noexcept {
  return -std::copysign(law.pull(std::max(0.0, std::abs(d_m) - relaxed_m)).N, d_m);
}

}  // namespace

Eigen::Vector3d skin_force_N(const SkinLaw& law, const Eigen::Vector3d& d_m, double relaxed_m) noexcept {
  if (relaxed_m > 0.0) {
    if (law.by_axis) return d_m.unaryExpr([&](double d) noexcept { return relaxed_force_N(law, d, relaxed_m); });
    const double depth_m = d_m.norm();
    return depth_m > relaxed_m ? Eigen::Vector3d(relaxed_force_N(law, depth_m, relaxed_m) / depth_m * d_m)
                               : Eigen::Vector3d::Zero();
  }
  if (!law.by_axis) return -law.stiffness_N_per_m(d_m.norm()) * d_m;
  // |d_i|: as printed, eq. (7) turns negative for a negative component.
  return {-law.stiffness_N_per_m(std::abs(d_m.x())) * d_m.x(), -law.stiffness_N_per_m(std::abs(d_m.y())) * d_m.y(),
          -law.stiffness_N_per_m(std::abs(d_m.z())) * d_m.z()};
}

Pull skin_pull(const SkinLaw& law, const Eigen::Vector3d& d_m, double relaxed_m) noexcept {
  if (!law.by_axis) return law.pull(std::max(0.0, d_m.norm() - relaxed_m));
  Pull sum;
  for (const double d : d_m) sum += law.pull(std::max(0.0, std::abs(d) - relaxed_m));
  return sum;
}

double skin_energy_J(const SkinLaw& law, const Eigen::Vector3d& d_m, double relaxed_m) noexcept {
  if (!law.by_axis) return relaxed_energy_J(law, d_m.norm(), relaxed_m);
  return relaxed_energy_J(law, std::abs(d_m.x()), relaxed_m) + relaxed_energy_J(law, std::abs(d_m.y()), relaxed_m) +
         relaxed_energy_J(law, std::abs(d_m.z()), relaxed_m);
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
  return law.pull(deepest_m).N_per_m;
}

}  // namespace telepalp::effects
