#include "haptic_station/control/parts/sink_in.h"

#include <algorithm>

namespace telepalp::control {
namespace {

constexpr double kEasesOver_s = 0.05;  // slower over the last 5 mm, so that it stops without a jerk
constexpr double kSlowest_m_per_s = 0.0003;
constexpr double kFastest_m_per_s = 0.1;  // together with the displayed surface's own approach to the measured one
constexpr double kFastestInGap_m_per_s = 0.15;  // where the body gives no force
constexpr double kClosesGapOver_s = 0.05;       // slower over the last 7.5 mm, so that it meets the hand gently

}  // namespace

void SinkIn::begin(const ports::SurfaceContact& contact) noexcept {
  lowered_m_ = std::max(0.0, -contact.distance_m);
  coverage_ = contact.coverage;
}

void SinkIn::step(const ports::SurfaceContact& contact, double dt_s) noexcept {
  const double felt_depth_m = std::max(0.0, -(contact.distance_m + lowered_m_));
  sank_m_ = contact.coverage > coverage_ ? (1.0 - coverage_ / contact.coverage) * felt_depth_m : 0.0;
  lowered_m_ += sank_m_;
  coverage_ = contact.coverage;
  rising_m_per_s_ = 0.0;
  if (lowered_m_ <= 0.0) return;
  const double in_gap_m_per_s = std::min((contact.distance_m + lowered_m_) / kClosesGapOver_s, kFastestInGap_m_per_s);
  const double surface_rises_m_per_s = std::max(0.0, contact.surface_speed_m_per_s - contact.measured_speed_m_per_s);
  // Negative where the displayed surface alone rises faster than both may together: the body is then lowered further.
  const double speed_m_per_s = std::min(std::max(lowered_m_ / kEasesOver_s, kSlowest_m_per_s),
                                        std::max(kFastest_m_per_s, in_gap_m_per_s) - surface_rises_m_per_s);
  const double risen_m = std::min(lowered_m_, speed_m_per_s * dt_s);
  rising_m_per_s_ = risen_m / std::max(dt_s, 1e-9);
  lowered_m_ -= risen_m;
}

ports::SurfaceContact SinkIn::shown(const ports::SurfaceContact& contact) const noexcept {
  ports::SurfaceContact shown = contact;
  if (lowered_m_ <= 0.0 && rising_m_per_s_ <= 0.0) return shown;
  // The proxy lies the share `coverage` of the way from the device to the surface, which is lowered.
  shown.proxy.m -= contact.coverage * lowered_m_ * contact.normal.v;
  shown.distance_m += lowered_m_;
  shown.surface_speed_m_per_s += rising_m_per_s_;
  return shown;
}

effects::EffectInput SinkIn::in_body_frame(const Point<HapticBase>& device, const Vector<HapticBase>& velocity,
                                           const ports::SurfaceContact& as_shown) const noexcept {
  const Eigen::Vector3d& normal = as_shown.normal.v;
  effects::EffectInput felt{device, velocity, as_shown, {}};
  felt.device.m += lowered_m_ * normal;
  felt.device_velocity.v -= rising_m_per_s_ * normal;
  felt.contact.proxy.m += lowered_m_ * normal;
  felt.contact.surface_speed_m_per_s -= rising_m_per_s_;
  return felt;
}

}  // namespace telepalp::control
