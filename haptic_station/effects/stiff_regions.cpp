#include "haptic_station/effects/stiff_regions.h"

#include <algorithm>
#include <cmath>

namespace telepalp::effects {

StiffRegions::StiffRegions(const Settings& settings) noexcept {
  for (const NamedRegion& one : settings.regions) (void)add(one.region);
}

bool StiffRegions::add(const StiffRegion& region) noexcept {
  if (count_ == kMostRegions) return false;
  regions_[count_++] = region;
  return true;
}

Force<HapticBase> StiffRegions::step(const EffectInput& in, double) noexcept {
  const double depth_m = std::max(0.0, -in.contact.distance_m);
  for (std::size_t i = 0; i < count_; ++i) {
    const StiffRegion& region = regions_[i];
    const Eigen::Vector3d from_axis{in.device.m.x() - region.center.m.x(), 0.0, in.device.m.z() - region.center.m.z()};
    const double r_m = from_axis.norm();
    const double u = std::clamp((r_m - region.radius_m) / region.fade_m, 0.0, 1.0);
    // The weight is (1 - u)^2 (1 + 2 u), a smooth step down from 1 to 0. `root` is its square root.
    const double steep = std::sqrt(1.0 + 2.0 * u);
    const double root = (1.0 - u) * steep;
    Eigen::Vector3d outwards = root * in.contact.normal.v;
    if (u > 0.0) outwards += depth_m * 3.0 * u / (steep * region.fade_m * r_m) * from_axis;
    springs_[i] = {skin_left_ * region.added_N_per_m, root * depth_m, outwards};
  }
  return force(0.0);
}

Pull StiffRegions::pull(double relaxed_m) const noexcept {
  Pull sum;
  for (std::size_t i = 0; i < count_; ++i) sum += springs_[i].pull(relaxed_m);
  return sum;
}

Force<HapticBase> StiffRegions::force(double relaxed_m) const noexcept {
  Force<HapticBase> sum;
  for (std::size_t i = 0; i < count_; ++i) sum.N += springs_[i].force(relaxed_m).N;
  return sum;
}

double StiffRegions::energy_J(double relaxed_m) const noexcept {
  double sum_J = 0.0;
  for (std::size_t i = 0; i < count_; ++i) sum_J += springs_[i].energy_J(relaxed_m);
  return sum_J;
}

double StiffRegions::stiffest_N_per_m(double) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i) sum += regions_[i].added_N_per_m;
  return sum;
}

}  // namespace telepalp::effects
