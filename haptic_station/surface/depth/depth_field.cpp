#include "haptic_station/surface/depth/depth_field.h"

#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

struct Span {
  double low = 0.0;
  double high = 0.0;
};

/// The interval of image coordinates that a sphere covers along one axis, from the slopes of its two tangent rays.
Span covered(double across_m, double depth_m, double radius_m, double focal_px, double centre_px) noexcept {
  const double angle = std::atan2(across_m, depth_m);
  const double half = std::asin(std::min(1.0, radius_m / std::hypot(across_m, depth_m)));
  constexpr double kWidest = 1.5;
  return {focal_px * std::tan(std::max(angle - half, -kWidest)) + centre_px,
          focal_px * std::tan(std::min(angle + half, kWidest)) + centre_px};
}

int to_pixel(double at, int most) noexcept { return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(most))); }

}  // namespace

DepthField to_depth_field(const DepthImage& depth) {
  DepthField field;
  to_depth_field(depth, field);
  return field;
}

void to_depth_field(const DepthImage& depth, DepthField& field) {
  field.width = depth.width;
  field.height = depth.height;
  field.z_m.resize(depth.samples.size());
  const auto unit = static_cast<float>(depth.unit_m);
  std::transform(depth.samples.begin(), depth.samples.end(), field.z_m.begin(),
                 [unit](std::uint16_t sample) { return unit * static_cast<float>(sample); });
}

PixelBox box_in_reach(const Intrinsics& camera, const std::optional<Reach>& reach, int margin_px) {
  const PixelBox whole{0, 0, camera.width, camera.height};
  if (!reach || !reach->centre.m.allFinite() || !std::isfinite(reach->radius_m)) return whole;
  const Eigen::Vector3d& at = reach->centre.m;
  if (at.norm() <= reach->radius_m) return whole;
  if (at.z() <= -reach->radius_m) return {};
  const Span u = covered(at.x(), at.z(), reach->radius_m, camera.fx, camera.cx);
  const Span v = covered(at.y(), at.z(), reach->radius_m, camera.fy, camera.cy);
  const double margin = margin_px;
  return {to_pixel(std::floor(u.low - margin), camera.width), to_pixel(std::floor(v.low - margin), camera.height),
          to_pixel(std::ceil(u.high + margin) + 1.0, camera.width),
          to_pixel(std::ceil(v.high + margin) + 1.0, camera.height)};
}

}  // namespace telepalp::surface
