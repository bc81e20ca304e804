#include "haptic_station/surface/touch/proxy.h"

#include <algorithm>

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

double height(const Vector3d& point, const ConstraintPlane& plane) noexcept {
  return plane.normal.dot(point - plane.at);
}

constexpr double kAllowed_m = 1e-12;

}  // namespace

Vector3d goal_on_plane(const Vector3d& device, const ConstraintPlane& plane) noexcept {
  return device - std::min(0.0, height(device, plane)) * plane.normal;
}

Vector3d goal_in_crease(const Vector3d& device, const ConstraintPlane& first, const ConstraintPlane& second) noexcept {
  const Vector3d on_first = goal_on_plane(device, first);
  if (height(on_first, second) >= -kAllowed_m) return on_first;
  const Vector3d on_second = goal_on_plane(device, second);
  if (height(on_second, first) >= -kAllowed_m) return on_second;
  // Both planes constrain: device + a·n1 + b·n2 lies on both, which is a 2×2 system with the cosine c between the
  // normals.
  const double c = first.normal.dot(second.normal);
  const double determinant = 1.0 - c * c;
  const double d1 = height(device, first);
  const double d2 = height(device, second);
  if (determinant < 1e-6) return d1 < d2 ? on_first : on_second;
  const double a = (-d1 + c * d2) / determinant;
  const double b = (-d2 + c * d1) / determinant;
  return device + a * first.normal + b * second.normal;
}

}  // namespace telepalp::surface
