#include "haptic_station/effects/skin.h"

namespace telepalp::effects {

void Skin::begin(const EffectInput& in) noexcept {
  // While the coverage is below 1, the proxy lies between the surface and the device; the anchor must lie on the
  // surface.
  const bool faded = in.contact.coverage < 1.0;
  first_contact_.m = faded ? in.device.m - in.contact.distance_m * in.contact.normal.v : in.contact.proxy.m;
  first_normal_ = in.contact.normal;
  carried_m_ = Eigen::Vector3d::Zero();
}

// The anchor moves with the skin at the first contact point. The speed under the hand is not used: a belly rises in its
// middle, so a hand that rubs in step with the breath would move the anchor out of the skin. The proxy's height is not
// used either: under a deep hand, the nearest skin point slides along the curved body while the patient lies still.
Vector<HapticBase> Skin::carried_at(const EffectInput& in) const noexcept {
  switch (settings_.anchor) {
    case SkinAnchor::Fixed:
      return {};
    case SkinAnchor::Sliding:
      return {in.contact.surface_speed_m_per_s * in.contact.normal.v};
    case SkinAnchor::FollowsSurface:
      if (in.contact.anchor_seen) return in.contact.anchor_velocity;
      return {in.contact.surface_speed_m_per_s * in.contact.normal.v.dot(first_normal_.v) * first_normal_.v};
  }
  return {};
}

Force<HapticBase> Skin::step(const EffectInput& in, double dt_s) noexcept {
  const bool slides = settings_.anchor == SkinAnchor::Sliding;
  const Eigen::Vector3d& normal = slides ? in.contact.normal.v : first_normal_.v;
  carried_m_ += carried_at(in).v * dt_s;
  Eigen::Vector3d d = in.device.m - (slides ? in.contact.proxy.m : first_contact_.m + carried_m_);
  const double outwards_m = d.dot(normal);
  if (outwards_m > 0.0) d -= outwards_m * normal;
  if (!slides) d *= in.contact.coverage;  // the coverage already scales the proxy
  indentation_ = {d};
  return {skin_force_N(law_, d)};
}

}  // namespace telepalp::effects
