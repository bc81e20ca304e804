#include "haptic_station/surface/temporal/straight_motion.h"

#include <algorithm>
#include <cmath>

namespace telepalp::surface {

StraightMotion::StraightMotion(const CellLattice& lattice)
    : lattice_(lattice),
      gains_(lattice),
      velocity_m_per_s_(lattice.size(), 0.0),
      displacement_m_(lattice.size(), 0.0F),
      measured_m_(lattice.size(), 0.0F),
      measured_m_per_s_(lattice.size(), 0.0F) {}

void StraightMotion::predict(double dt_s) noexcept {
  for (std::size_t at = 0; at < displacement_m_.size(); ++at)
    displacement_m_[at] += static_cast<float>(velocity_m_per_s_[at] * dt_s);
}

void StraightMotion::correct(std::span<const CellInnovation> seen, std::span<const float> modelled_m, double dt_s) {
  std::vector<float> between(displacement_m_.size());
  std::transform(modelled_m.begin(), modelled_m.end(), displacement_m_.begin(), between.begin(), std::minus<>());
  const std::vector<float> offset_m = means_of(lattice_, between);
  std::vector<CellMean> innovation(seen.size());
  for (std::size_t at = 0; at < seen.size(); ++at)
    innovation[at] = {seen[at].mean_m + static_cast<double>(offset_m[at]), seen[at].count};
  gains_.add(seen, wide_means(lattice_, innovation));
  const std::vector<float> smooth_m = smooth_coefficients(lattice_, innovation);
  for (std::size_t at = 0; at < seen.size(); ++at) {
    displacement_m_[at] += static_cast<float>(gains_.position(at)) * smooth_m[at];
    velocity_m_per_s_[at] += gains_.velocity(at) * static_cast<double>(smooth_m[at]) / dt_s;
  }
  smooth_velocities(lattice_, velocity_m_per_s_);
}

void StraightMotion::measure(std::span<const float> measured_m, double dt_s) {
  for (std::size_t at = 0; at < measured_m.size(); ++at) {
    measured_m_per_s_[at] = (measured_m[at] - measured_m_[at]) / static_cast<float>(dt_s);
    measured_m_[at] = measured_m[at];
  }
}

double StraightMotion::velocity_m_per_s(std::size_t cell) const noexcept {
  const double velocity = velocity_m_per_s_[cell];
  const double measured = std::copysign(1.0, velocity) * static_cast<double>(measured_m_per_s_[cell]);
  const double most = kMeasuredShare * std::max(0.0, measured) + kMeasuredMargin_m_per_s;
  return std::clamp(velocity, -most, most);
}

}  // namespace telepalp::surface
