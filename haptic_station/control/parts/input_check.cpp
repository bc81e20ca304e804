#include "haptic_station/control/parts/input_check.h"

#include <cmath>

namespace telepalp::control {
namespace {

bool is_finite(const ports::SurfaceContact& contact) noexcept {
  return contact.proxy.m.allFinite() && contact.normal.v.allFinite() && std::isfinite(contact.distance_m) &&
         std::isfinite(contact.surface_speed_m_per_s) && std::isfinite(contact.measured_above_m) &&
         std::isfinite(contact.measured_speed_m_per_s) && std::isfinite(contact.coverage) &&
         (!contact.anchor_seen || contact.anchor_velocity.v.allFinite());
}

bool is_finite(const effects::Placements& placements) noexcept {
  // Zero times a finite number is zero, and NaN otherwise. Testing the 48 numbers one by one takes five times as long.
  Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  for (const effects::Placement& one : placements) zero += 0.0 * one.moved.v + 0.0 * one.velocity.v;
  return zero == Eigen::Vector3d::Zero();
}

}  // namespace

bool is_finite(const ControlInput& in) noexcept {
  return in.device.m.allFinite() && in.device_velocity.v.allFinite() && std::isfinite(in.device_age_s) &&
         in.recall.N.allFinite() && in.reindexed.v.allFinite() && std::isfinite(in.device_implausible_s) &&
         !std::isnan(in.device_unreadable_s) && std::isfinite(in.hand_implausible_s) &&
         (!in.attitude || (in.attitude->coeffs().allFinite() && in.turning.v.allFinite())) &&
         (!in.hand_valid || (in.hand.m.allFinite() && in.hand_velocity.v.allFinite())) &&
         (!in.contact.valid || is_finite(in.contact)) && is_finite(in.placements);
}

ControlInput blank_input(const ControlInput& in, const Point<HapticBase>& device) noexcept {
  constexpr double kTooOld_s = 1e9;
  ControlInput blank;
  blank.device = device;
  blank.hand = device;
  blank.device_age_s = blank.hand_age_s = blank.contact.age_s = kTooOld_s;
  blank.rearm = in.rearm;
  return blank;
}

FaultCause standing_fault(const ControlInput& in, bool touching, const AgeLimits& ages) noexcept {
  if (!is_finite(in)) return FaultCause::NotFinite;
  if (!(in.device_age_s <= ages.device_s)) return FaultCause::DeviceSilent;
  if (!(in.device_implausible_s <= ages.implausible_s)) return FaultCause::DeviceImplausible;
  const bool jumps = in.hand_valid && !(in.hand_implausible_s <= ages.hand_implausible_s);
  return jumps && !touching ? FaultCause::HandImplausible : FaultCause::None;
}

// Each comparison is true only for a valid age; it is false for NaN.
bool surface_is_stale(const ControlInput& in, const AgeLimits& ages) noexcept {
  return !(in.contact.age_s <= ages.surface_s);
}

bool device_is_unreadable(const ControlInput& in, const AgeLimits& ages) noexcept {
  return !(in.device_unreadable_s <= ages.unreadable_s);
}

bool hand_is_lost(const ControlInput& in, double limit_s) noexcept {
  return !(in.hand_valid && in.hand_age_s <= limit_s && in.hand_age_s >= -limit_s);
}

}  // namespace telepalp::control
