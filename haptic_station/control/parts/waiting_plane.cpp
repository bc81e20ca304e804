#include "haptic_station/control/parts/waiting_plane.h"

#include <algorithm>

namespace telepalp::control {

void WaitingPlane::move(const Point<HapticBase>& device, const ports::SurfaceContact& contact, double dt_s) noexcept {
  double wanted_m = settings_.height_m;
  if (contact.valid) {
    const double skin_m = device.m.y() - contact.distance_m * contact.normal.v.y();
    wanted_m = std::max(wanted_m, skin_m + settings_.clearance_m);
  }
  if (!placed_) height_m_ = wanted_m;
  placed_ = true;
  const double most_m = settings_.speed_m_per_s * dt_s;
  height_m_ += std::clamp(wanted_m - height_m_, -most_m, most_m);
}

}  // namespace telepalp::control
