#include "haptic_station/solids/solid_picture.h"

#include <Eigen/Geometry>
#include <cmath>

namespace telepalp::solids {
namespace {

using Eigen::Vector3d;

constexpr int kMostSteps = 200;
constexpr double kAmbient = 0.25;

struct Met {
  SolidAt at;
  std::size_t solid;
};

Met nearest(std::span<const PaintedSolid> solids, const Vector3d& p) noexcept {
  Met met{{std::numeric_limits<double>::infinity(), Vector3d::Zero(), 0}, 0};
  for (std::size_t i = 0; i < solids.size(); ++i) {
    SolidAt at = solid_at(*solids[i].tree, p);
    at.m /= solids[i].tree->steepest;
    if (at.m < met.at.m) met = {at, i};
  }
  return met;
}

std::array<std::uint8_t, 3> seen_along(std::span<const PaintedSolid> solids, Vector3d p, const PictureView& view) {
  const double on_m = 1e-4 * view.width_m;
  double gone_m = 0.0;
  for (int i = 0; i < kMostSteps && gone_m < 4.0 * view.width_m; ++i) {
    const Met met = nearest(solids, p);
    if (met.at.m <= on_m) {
      const double facing = std::max(0.0, -met.at.gradient.normalized().dot(view.towards));
      std::array<std::uint8_t, 3> rgb = solids[met.solid].rgb;
      for (std::uint8_t& one : rgb)
        one = static_cast<std::uint8_t>(std::lround(one * (kAmbient + (1.0 - kAmbient) * facing)));
      return rgb;
    }
    p += met.at.m * view.towards;
    gone_m += met.at.m;
  }
  return {255, 255, 255};
}

}  // namespace

ColorImage picture_of(std::span<const PaintedSolid> solids, const PictureView& view) {
  ColorImage image{.width = view.side_px, .height = view.side_px, .rgb = {}};
  const Vector3d right = view.towards.cross(view.up);
  const double pixel_m = view.width_m / view.side_px;
  for (int v = 0; v < view.side_px; ++v)
    for (int u = 0; u < view.side_px; ++u) {
      const double x = (u + 0.5 - 0.5 * view.side_px) * pixel_m;
      const double y = (0.5 * view.side_px - v - 0.5) * pixel_m;
      const Vector3d eye = view.center + x * right + y * view.up - 2.0 * view.width_m * view.towards;
      const auto rgb = seen_along(solids, eye, view);
      image.rgb.insert(image.rgb.end(), rgb.begin(), rgb.end());
    }
  return image;
}

}  // namespace telepalp::solids
