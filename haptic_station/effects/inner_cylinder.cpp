#include "haptic_station/effects/inner_cylinder.h"

#include <algorithm>
#include <cmath>

namespace telepalp::effects {
namespace {

struct Depths {
  double top_m;      ///< depth below the upper face
  double bottom_m;   ///< height above the lower face
  double lateral_m;  ///< depth inside the lateral face
};

double smallest(const Depths& d) noexcept { return std::min({d.top_m, d.bottom_m, d.lateral_m}); }

/// s = (a^-p + b^-p + c^-p)^(-1/p) and its derivatives by a, b, c; all depths positive. With p = 8 it is 0.5 % below
/// the least depth when the second is 1.5 times as large and the third much larger.
struct SmoothDepth {
  double s_m;
  Depths by;
};
SmoothDepth smooth_minimum(const Depths& d) noexcept {
  constexpr double kSharpness = 8.0;
  const double least = smallest(d);
  const auto share = [&](double depth) { return std::pow(least / depth, kSharpness); };
  const double sum = share(d.top_m) + share(d.bottom_m) + share(d.lateral_m);
  const double s = least * std::pow(sum, -1.0 / kSharpness);
  const auto by = [&](double depth) { return std::pow(s / depth, kSharpness + 1.0); };
  return {s, {by(d.top_m), by(d.bottom_m), by(d.lateral_m)}};
}

/// Distance from the axis with its gradient's length along the radius. Within `core_m` of the axis the distance is
/// rounded, because the mantle has no direction on the axis.
struct Radial {
  double m;
  double per_m;  ///< times the vector from the axis: the gradient
};
Radial rounded(double radial_m, double core_m) noexcept {
  if (radial_m >= core_m) return {radial_m, 1.0 / radial_m};
  return {0.5 * (radial_m * radial_m / core_m + core_m), 1.0 / core_m};
}

/// The depth outside: minus the largest excess over a face. It is exact except beyond an edge, where it is slightly too
/// small.
SolidDepth outside(const Depths& d, const Eigen::Vector3d& radial) noexcept {
  const double least = smallest(d);
  if (least == d.lateral_m) return {least, radial};
  return {least, (least == d.top_m ? 1.0 : -1.0) * Eigen::Vector3d::UnitY()};
}

}  // namespace

SolidDepth InnerCylinder::depth_at(const Eigen::Vector3d& from_top) const noexcept {
  constexpr double kCore = 0.1;  // of the radius
  const Radial from_axis = rounded(std::hypot(from_top.x(), from_top.z()), kCore * settings_.radius_m);
  const Eigen::Vector3d radial = from_axis.per_m * Eigen::Vector3d{from_top.x(), 0.0, from_top.z()};
  const Depths depths{-from_top.y(), settings_.height_m + from_top.y(), settings_.radius_m - from_axis.m};
  if (smallest(depths) <= 1e-9) return outside(depths, radial);
  const SmoothDepth smooth = smooth_minimum(depths);
  return {smooth.s_m, Eigen::Vector3d::UnitY() * (smooth.by.top_m - smooth.by.bottom_m) + radial * smooth.by.lateral_m};
}

Force<HapticBase> InnerCylinder::step(const EffectInput& in, double dt_s) noexcept {
  const Eigen::Vector3d from_top = in.device.m - settings_.top_center.m;
  const auto felt = entry_.step(from_top, in.contact.normal.v, dt_s,
                                [this](const Eigen::Vector3d& point) noexcept { return depth_at(point); });
  spring_ = {};
  if (felt.depth_m <= 0.0) {
    touch_ = -depth_at(from_top).m <= kAround_m ? ObjectTouch::Near : ObjectTouch::None;
    return {};
  }
  touch_ =
      felt.outwards.y() >= std::hypot(felt.outwards.x(), felt.outwards.z()) ? ObjectTouch::Upper : ObjectTouch::Lateral;
  spring_ = {felt.share * settings_.stiffness_N_per_m, felt.depth_m, felt.outwards};
  return spring_.force(0.0);
}

}  // namespace telepalp::effects
