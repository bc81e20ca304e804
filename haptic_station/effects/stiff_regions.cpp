#include "haptic_station/effects/stiff_regions.h"

#include <algorithm>
#include <cmath>

#include "proto/words/smooth_step.h"

namespace telepalp::effects {

bool StiffRegions::add(const StiffRegion& region) noexcept {
  if (count_ == kMostRegions) return false;
  regions_[count_++] = region;
  return true;
}

Force<HapticBase> StiffRegions::step(const EffectInput& in, double) noexcept {
  energy_J_ = 0.0;
  const double depth_m = -in.contact.distance_m;
  if (depth_m <= 0.0) return {};
  Force<HapticBase> sum;
  for (std::size_t i = 0; i < count_; ++i) {
    const StiffRegion& region = regions_[i];
    const double x_m = in.device.m.x() - region.center.m.x();
    const double z_m = in.device.m.z() - region.center.m.z();
    const double r_m = std::hypot(x_m, z_m);
    const double u = std::clamp((r_m - region.radius_m) / region.fade_m, 0.0, 1.0);
    const double weight = 1.0 - smooth_step(u);
    const double weight_per_m = -6.0 * u * (1.0 - u) / region.fade_m;
    const double energy_J = 0.5 * region.added_N_per_m * depth_m * depth_m;
    energy_J_ += energy_J * weight;
    sum.N += region.added_N_per_m * weight * depth_m * in.contact.normal.v;
    if (r_m > 1e-9) sum.N -= energy_J * weight_per_m / r_m * Eigen::Vector3d{x_m, 0.0, z_m};
  }
  return sum;
}

double StiffRegions::stiffest_N_per_m(double) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i) sum += regions_[i].added_N_per_m;
  return sum;
}

}  // namespace telepalp::effects
