#include "haptic_station/station/picture/ground.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "haptic_station/station/picture/picture_view.h"
#include "haptic_station/station/picture/pixels.h"

namespace telepalp::station {
namespace {

using Eigen::Vector3d;
using images::Rgb;
using solids::PictureView;

constexpr Rgb kGrid{228, 200, 180};

void draw_grid(ColorImage& ground, const PictureView& view, int line_px) {
  const double step_px = grid_step_m(view.width_m) / view.width_m * view.side_px;
  const Seen origin = seen_at(view, Vector3d::Zero());
  for (double x = std::fmod(origin.x, step_px) - step_px; x < view.side_px; x += step_px)
    images::fill(ground, {static_cast<int>(std::lround(x)), 0, line_px, view.side_px}, kGrid);
  for (double y = std::fmod(origin.y, step_px) - step_px; y < view.side_px; y += step_px)
    images::fill(ground, {0, static_cast<int>(std::lround(y)), view.side_px, line_px}, kGrid);
}

/// The flat skin: it fills a picture from above, and the part below y = 0 in a picture from a side.
ColorImage flat_ground(const PictureView& view, int line_px) {
  const bool above = view.up.y() < 0.5;
  ColorImage ground = blank(view.side_px, view.side_px, kSkin);
  draw_grid(ground, view, line_px);
  if (above) return ground;
  const int skin_px = static_cast<int>(std::lround(seen_at(view, Vector3d::Zero()).y));
  images::fill(ground, {0, 0, view.side_px, skin_px}, kWhite);
  images::fill(ground, {0, skin_px - line_px, view.side_px, 2 * line_px}, kInk);
  return ground;
}

/// Discs around the skin's points, large enough to leave no gap, the nearest on top.
ColorImage model_ground(const PictureView& view, std::span<const SkinPoint> skin, int line_px) {
  ColorImage ground = blank(view.side_px, view.side_px, kWhite);
  draw_grid(ground, view, line_px);
  std::vector<Seen> discs;
  Eigen::AlignedBox2d area;
  for (const SkinPoint& point : skin) {
    discs.push_back(seen_at(view, point.at_m));
    area.extend(Eigen::Vector2d(discs.back().x, discs.back().y));
  }
  const double radius_px = 1.3 * std::sqrt(area.volume() / static_cast<double>(skin.size()));
  std::vector<double> nearest(ground.rgb.size() / 3, -std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const double facing = -skin[i].outwards.dot(view.towards);
    if (facing <= 0.0) continue;
    const Rgb rgb = mixed(kInk, kSkin, 0.35 + 0.65 * facing);
    const auto low = [](double px) { return std::max(0, static_cast<int>(std::ceil(px))); };
    const auto high = [&](double px) { return std::min(view.side_px - 1, static_cast<int>(std::floor(px))); };
    for (int y = low(discs[i].y - radius_px); y <= high(discs[i].y + radius_px); ++y)
      for (int x = low(discs[i].x - radius_px); x <= high(discs[i].x + radius_px); ++x) {
        const double off = std::hypot(x - discs[i].x, y - discs[i].y);
        // A cone instead of a disc: between two points the nearer one is seen.
        const double nearness_m = discs[i].nearness_m - 0.5 * off / view.side_px * view.width_m;
        double& before = nearest[index_of(ground, x, y)];
        if (off > radius_px || nearness_m <= before) continue;
        before = nearness_m;
        set_pixel(ground, x, y, rgb);
      }
  }
  return ground;
}

}  // namespace

ColorImage ground_of(const PictureView& view, std::span<const SkinPoint> skin, int line_px) {
  return skin.empty() ? flat_ground(view, line_px) : model_ground(view, skin, line_px);
}

}  // namespace telepalp::station
