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

/// Distance of a point outside the cylinder: the largest excess over a face. It is exact except beyond an edge, where
/// it is slightly too small.
double outside_by_m(const Depths& d) noexcept { return -smallest(d); }

}  // namespace

Force<HapticBase> InnerCylinder::step(const EffectInput& in, double) noexcept {
  const Eigen::Vector3d from_top = in.device.m - settings_.top_center.m;
  const double radial_m = std::hypot(from_top.x(), from_top.z());
  const Depths depths{-from_top.y(), settings_.height_m + from_top.y(), settings_.radius_m - radial_m};
  energy_J_ = 0.0;
  if (smallest(depths) <= 1e-9) {
    touch_ = outside_by_m(depths) <= settings_.around_m ? ObjectTouch::Near : ObjectTouch::None;
    return {};
  }
  const SmoothDepth smooth = smooth_minimum(depths);
  const Eigen::Vector3d radial = radial_m > 1e-9
                                     ? Eigen::Vector3d{from_top.x() / radial_m, 0.0, from_top.z() / radial_m}
                                     : Eigen::Vector3d::Zero();
  const Eigen::Vector3d outwards =
      Eigen::Vector3d::UnitY() * (smooth.by.top_m - smooth.by.bottom_m) + radial * smooth.by.lateral_m;
  touch_ = smooth.by.top_m >= smooth.by.lateral_m ? ObjectTouch::Upper : ObjectTouch::Lateral;
  energy_J_ = 0.5 * settings_.stiffness_N_per_m * smooth.s_m * smooth.s_m;
  return {settings_.stiffness_N_per_m * smooth.s_m * outwards};
}

}  // namespace telepalp::effects
