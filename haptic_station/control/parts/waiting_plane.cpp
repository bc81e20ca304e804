#include "haptic_station/control/parts/waiting_plane.h"

#include <cmath>

namespace telepalp::control {

namespace {

constexpr double kDemandSlack_m = 0.02;
constexpr double kDemandSpeed = 2.0;  // of a demanded target, in units of the plane's speed: no person holds the device

/// `from`, moved towards `to` by at most `most`.
double towards(double from, double to, double most) noexcept {
  return std::abs(to - from) <= most ? to : from + std::copysign(most, to - from);
}

}  // namespace

void WaitingPlane::move(const Point<HapticBase>& device, const ports::SurfaceContact& contact,
                        const std::optional<double>& wait_at_m, double dt_s) noexcept {
  const bool demanded = wait_at_m && std::isfinite(*wait_at_m);
  double wanted_m = demanded ? *wait_at_m - kDemandSlack_m : settings_.height_m;
  if (contact.valid && !demanded) {
    const double skin_m = device.m.y() - contact.distance_m * contact.normal.v.y();
    wanted_m = std::max(wanted_m, skin_m + settings_.clearance_m);
  }
  if (!placed_) height_m_ = raised_m_ = wanted_m;
  placed_ = true;
  const double most_m = settings_.speed_m_per_s * dt_s;
  const double share = demanded ? kDemandSpeed : 1.0;
  const double held_m =
      std::max(raised_m_, height_m_);  // before the plane moves, or the target would move by both steps
  height_m_ += std::clamp(wanted_m - height_m_, -share * most_m, share * most_m);
  raised_m_ = towards(held_m, demanded ? *wait_at_m : height_m_, share * most_m);
}

}  // namespace telepalp::control
