#include "haptic_station/solids/solid_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

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

/// Traces the rays of a square picture tile by tile: the middle ray of a tile advances while the nearest solid is
/// farther away than the tile's rays, then the four quarters of the tile go on from there.
class Tracer {
 public:
  Tracer(std::span<const PaintedSolid> solids, const PictureView& view)
      : solids_(solids), view_(view), right_(view.towards.cross(view.up)), pixel_m_(view.width_m / view.side_px) {
    image_ = {.width = view.side_px, .height = view.side_px, .rgb = {}};
    image_.rgb.assign(3 * static_cast<std::size_t>(view.side_px) * static_cast<std::size_t>(view.side_px), 255);
  }

  ColorImage trace() {
    int side = 1;
    while (side < view_.side_px) side *= 2;
    tile(0, 0, side, 0.0);
    return std::move(image_);
  }

 private:
  [[nodiscard]] Vector3d eye(double u, double v) const {
    const double x = (u - 0.5 * view_.side_px) * pixel_m_;
    const double y = (0.5 * view_.side_px - v) * pixel_m_;
    return view_.center + x * right_ + y * view_.up - 2.0 * view_.width_m * view_.towards;
  }

  /// `gone_m`: no ray of the tile meets a solid before it.
  void tile(int left, int top, int side, double gone_m) {
    if (left >= view_.side_px || top >= view_.side_px) return;
    if (side == 1) return pixel(left, top, gone_m);
    const double reach_m = 0.5 * side * pixel_m_ * std::numbers::sqrt2;
    const Vector3d from = eye(left + 0.5 * side, top + 0.5 * side);
    for (int i = 0; i < kMostSteps; ++i) {
      if (gone_m >= 4.0 * view_.width_m) return;
      const double free_m = nearest(solids_, from + gone_m * view_.towards).at.m;
      if (free_m < 1.05 * reach_m) break;
      gone_m += std::sqrt(free_m * free_m - reach_m * reach_m);
    }
    const int half = side / 2;
    for (int quarter = 0; quarter < 4; ++quarter)
      tile(left + half * (quarter % 2), top + half * (quarter / 2), half, gone_m);
  }

  void pixel(int u, int v, double gone_m) {
    const double on_m = 1e-4 * view_.width_m;
    const Vector3d from = eye(u + 0.5, v + 0.5);
    for (int i = 0; i < kMostSteps && gone_m < 4.0 * view_.width_m; ++i) {
      const Met met = nearest(solids_, from + gone_m * view_.towards);
      if (met.at.m <= on_m) return paint(u, v, met);
      gone_m += met.at.m;
    }
  }

  void paint(int u, int v, const Met& met) {
    const double facing = std::max(0.0, -met.at.gradient.normalized().dot(view_.towards));
    const auto first =
        3 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(view_.side_px) + static_cast<std::size_t>(u));
    for (std::size_t i = 0; i < 3; ++i)
      image_.rgb[first + i] =
          static_cast<std::uint8_t>(std::lround(solids_[met.solid].rgb[i] * (kAmbient + (1.0 - kAmbient) * facing)));
  }

  std::span<const PaintedSolid> solids_;
  const PictureView& view_;  // borrowed
  Vector3d right_;
  double pixel_m_;
  ColorImage image_;
};

}  // namespace

ColorImage picture_of(std::span<const PaintedSolid> solids, const PictureView& view) {
  return Tracer(solids, view).trace();
}

}  // namespace telepalp::solids
