#include "haptic_station/effects/skin.h"

namespace telepalp::effects {
namespace {

Eigen::Vector3d anchor_now(SkinAnchor kind, const Eigen::Vector3d& first, const Eigen::Vector3d& first_normal,
                           const Eigen::Vector3d& proxy) noexcept {
  if (kind == SkinAnchor::Sliding) return proxy;
  if (kind == SkinAnchor::Fixed) return first;
  return first + first_normal * (proxy - first).dot(first_normal);
}

}  // namespace

void Skin::begin(const EffectInput& in) noexcept {
  first_contact_ = in.contact.proxy;
  first_normal_ = in.contact.normal;
}

Force<HapticBase> Skin::step(const EffectInput& in, double) noexcept {
  const Eigen::Vector3d anchor = anchor_now(settings_.anchor, first_contact_.m, first_normal_.v, in.contact.proxy.m);
  Eigen::Vector3d d = in.device.m - anchor;
  const Eigen::Vector3d& normal = settings_.anchor == SkinAnchor::Sliding ? in.contact.normal.v : first_normal_.v;
  const double outwards_m = d.dot(normal);
  if (outwards_m > 0.0) d -= outwards_m * normal;
  indentation_ = {d};
  return {skin_force_N(settings_.law, d)};
}

Vector<HapticBase> Skin::carried_at(const EffectInput& in) const noexcept {
  if (settings_.anchor == SkinAnchor::Fixed) return {};
  return {in.contact.surface_speed_m_per_s * in.contact.normal.v};
}

}  // namespace telepalp::effects
