#include "haptic_station/core/inside/held_probe.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "haptic_station/core/window/tick_vector.h"

namespace telepalp::core {
namespace {

using Eigen::Vector3d;

constexpr double kLeastFacing = 0.5;  // cosine of the largest angle between scan lines and the skin's inward normal

/// The hand's axes in K; nullopt: not known.
std::optional<Eigen::Matrix3d> axes_of(const std::array<float, 4>& xyzw) noexcept {
  const Eigen::Quaterniond q(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
  if (!(q.norm() > 0.5)) return std::nullopt;
  return q.normalized().toRotationMatrix();
}

/// The part of `v` that is perpendicular to `unit`, normalised; any perpendicular direction if there is none.
Vector3d across(const Vector3d& v, const Vector3d& unit) noexcept {
  const Vector3d part = v - v.dot(unit) * unit;
  return part.norm() > 1e-3 ? Vector3d(part.normalized()) : Vector3d(unit.unitOrthogonal());
}

}  // namespace

HeldProbe held_probe(const loop::TickSample& tick,
                     const Transform<HapticBase, DepthCamera>& haptic_from_camera) noexcept {
  HeldProbe probe;
  const Vector3d normal = vector_of(tick.normal);
  if (!tick.in_body || tick.contact_unknown || !(std::abs(normal.norm() - 1.0) < 0.1)) return probe;
  const Vector3d inwards = -normal.normalized();
  const Eigen::Matrix3d haptic_from_k = haptic_from_camera.iso.linear();
  const auto axes = axes_of(tick.hand_attitude_camera);
  const Vector3d along = axes ? Vector3d(-(haptic_from_k * axes->col(2))) : inwards;
  probe.pose.at = vector_of(tick.proxy);
  probe.pose.into_body = along;
  probe.pose.across = across(haptic_from_k * (axes ? Vector3d(axes->col(0)) : Vector3d::UnitX()), along);
  probe.on_skin = along.dot(inwards) >= kLeastFacing;
  return probe;
}

}  // namespace telepalp::core
