#include "haptic_station/effects/skin.h"

namespace telepalp::effects {

void Skin::begin(const EffectInput& in) noexcept {
  first_contact_ = in.contact.proxy;
  first_normal_ = in.contact.normal;
  rise_m_ = 0.0;
}

// The proxy's own height would not do: under a deep hand the nearest skin slides along the body's curvature, and the
// anchor would ride up and down with it while the patient lies still.
Vector<HapticBase> Skin::carried_at(const EffectInput& in) const noexcept {
  switch (settings_.anchor) {
    case SkinAnchor::Fixed:
      return {};
    case SkinAnchor::Sliding:
      return {in.contact.surface_speed_m_per_s * in.contact.normal.v};
    case SkinAnchor::FollowsSurface:
      return {in.contact.surface_speed_m_per_s * in.contact.normal.v.dot(first_normal_.v) * first_normal_.v};
  }
  return {};
}

Force<HapticBase> Skin::step(const EffectInput& in, double dt_s) noexcept {
  const bool slides = settings_.anchor == SkinAnchor::Sliding;
  const Eigen::Vector3d& normal = slides ? in.contact.normal.v : first_normal_.v;
  rise_m_ += carried_at(in).v.dot(first_normal_.v) * dt_s;
  Eigen::Vector3d d = in.device.m - (slides ? in.contact.proxy.m : first_contact_.m + rise_m_ * first_normal_.v);
  const double outwards_m = d.dot(normal);
  if (outwards_m > 0.0) d -= outwards_m * normal;
  indentation_ = {d};
  return {skin_force_N(settings_.law, d)};
}

}  // namespace telepalp::effects
