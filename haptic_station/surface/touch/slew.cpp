#include "haptic_station/surface/touch/slew.h"

#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr double kSteepestShare = 1.5;  // of the smooth step, at its middle

}  // namespace

double Slew::share() const noexcept {
  const double t = left_s_ / lasts_s_;
  return t * t * (3.0 - 2.0 * t);
}

FieldSample Slew::shown(const FieldSample& raw, const Vector3d& query) const noexcept {
  if (!active() || !raw.valid) return raw;
  const Vector3d from = query - at_;
  const double s = from.squaredNorm() / (reach_m_ * reach_m_);
  if (s >= 1.0) return raw;
  const double near = (1.0 - s) * (1.0 - s);
  const Vector3d near_by_m = -4.0 * (1.0 - s) / (reach_m_ * reach_m_) * from;
  const double difference = offset_m_ + tilt_.dot(from);
  FieldSample out = raw;
  out.f_m += share() * near * difference;
  out.gradient += share() * (near * tilt_ + difference * near_by_m);
  const double length = out.gradient.norm();
  if (length > 0.1) out.normal = out.gradient / length;
  out.velocity_m_per_s += near * velocity_m_per_s();
  return out;
}

void Slew::begin(const FieldSample& old_shown, const FieldSample& fresh, const Vector3d& at,
                 const SlewSettings& settings) noexcept {
  begin(old_shown.f_m - fresh.f_m, old_shown.gradient - fresh.gradient, at, settings);
}

void Slew::begin(double offset_m, const Vector3d& tilt, const Vector3d& at, const SlewSettings& settings) noexcept {
  offset_m_ = offset_m;
  tilt_ = tilt;
  at_ = at;
  reach_m_ = settings.reach_m;
  const double needed_s =
      kSteepestShare * std::max(std::abs(offset_m) / settings.speed_m_per_s, tilt.norm() / settings.turn_rad_per_s);
  lasts_s_ = std::clamp(needed_s, settings.least_s, std::max(settings.least_s, settings.most_s));
  left_s_ = lasts_s_;
}

void Slew::advance(double dt_s) noexcept { left_s_ = std::max(0.0, left_s_ - dt_s); }

double Slew::velocity_m_per_s() const noexcept {
  if (!active()) return 0.0;
  const double t = left_s_ / lasts_s_;
  return offset_m_ * 6.0 * t * (1.0 - t) / lasts_s_;  // f falls by it, so the surface rises
}

}  // namespace telepalp::surface
