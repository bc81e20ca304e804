#include "haptic_station/surface/grid/skin_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "haptic_station/surface/grid/skin_moments.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr double kLeastFacing = 0.1;      // cosine; nearer to a silhouette, no neighbour is left along the slant
constexpr double kLeastAlong_px = 2.5;    // least radius of the window along the slant
constexpr double kLeastWeight = 3.0;      // pixels
constexpr double kLeastPivot = 1e-4;      // of the sum of the weights
constexpr double kSettledCosine = 0.990;  // 8 degrees
constexpr int kMostFits = 3;

struct TangentFrame {
  Vector3d across;
  Vector3d down;
};

TangentFrame tangents_of(const Vector3d& normal) noexcept {
  const bool upright = std::abs(normal.x()) < std::abs(normal.y());
  const Vector3d across = normal.cross(upright ? Vector3d::UnitX() : Vector3d::UnitY()).normalized();
  return {across, normal.cross(across)};
}

std::array<float, 3> narrowed(const Vector3d& v) noexcept {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

/// The half sides [px], in columns and rows, of the box around a disc of `radius_px` pixels that face the camera, on
/// the tangent plane. Where the disc looks narrow, the skin's curvature widens it by up to two pixels. The weights are
/// 0 at the disc's rim.
Pixel half_box(const SkinPoint& point, double radius_px) noexcept {
  const double per_z = 1.0 / point.at.z();
  const auto along = [&](const Vector3d& by_m) {
    const double to_plane = by_m.dot(point.normal);
    const double slope = std::min(1.0, std::sqrt(std::max(0.0, by_m.squaredNorm() - to_plane * to_plane)));
    return static_cast<int>(radius_px * slope + 2.0 * (1.0 - slope) - 1e-3);
  };
  return {along({1.0, 0.0, -point.at.x() * per_z}), along({0.0, 1.0, -point.at.y() * per_z})};
}

/// Height and slopes at the frame's origin, in the window's radii.
struct HeightTerms {
  double height = 0.0;
  double by_u = 0.0;
  double by_v = 0.0;
  double gain = 1.0;  ///< upper bound on the variance of the height / the variance of one pixel
};

/// The normal equations of u², uv, v², u, v and 1, with the right side as the seventh column.
using HeightEquations = std::array<std::array<double, 7>, 6>;

HeightEquations equations_of(const SkinMoments& sums) noexcept {
  const auto& w = sums.weight;
  const auto& h = sums.height;
  return {{{w[10], w[11], w[12], w[6], w[7], w[3], h[3]},
           {w[11], w[12], w[13], w[7], w[8], w[4], h[4]},
           {w[12], w[13], w[14], w[8], w[9], w[5], h[5]},
           {w[6], w[7], w[8], w[3], w[4], w[1], h[1]},
           {w[7], w[8], w[9], w[4], w[5], w[2], h[2]},
           {w[3], w[4], w[5], w[1], w[2], w[0], h[0]}}};
}

/// Eliminates from the term `from` on, without pivoting, and solves for the last three terms alone: nobody needs the
/// others, and a steep scene has thousands of nodes. `from` 0: a quadratic; 3: a plane. nullopt: the terms are not
/// distinct, because too few pixels lie along the slant.
std::optional<HeightTerms> solve_from(std::size_t from, HeightEquations equations) noexcept {
  const double least = kLeastPivot * equations[5][5];
  for (std::size_t k = from; k < 6; ++k) {
    if (!(equations[k][k] > least)) return std::nullopt;
    const double inverse = 1.0 / equations[k][k];
    for (std::size_t i = k + 1; i < 6; ++i) {
      const double share = equations[k][i] * inverse;
      for (std::size_t j = i; j < 7; ++j) equations[i][j] -= share * equations[k][j];
    }
  }
  HeightTerms terms;
  terms.gain = 1.0 / equations[5][5];
  terms.height = equations[5][6] * terms.gain;
  terms.by_v = (equations[4][6] - equations[4][5] * terms.height) / equations[4][4];
  terms.by_u = (equations[3][6] - equations[3][5] * terms.height - equations[3][4] * terms.by_v) / equations[3][3];
  return terms;
}

/// The box with the sides 2 `half` + 1 in the middle of the window of `mask`, as far as the view has it.
SkinWindow window_of(const InverseDepthView& view, const ViewCamera& from, const WindowMask& mask, Pixel centre,
                     int radius, Pixel half) noexcept {
  const Pixel corner{centre.column - radius, centre.row - radius};
  const auto ray = [](double pixel, double principal, double focal) {
    return static_cast<float>((pixel - principal) / focal);
  };
  return {.image = view.per_m.data(),
          .first = static_cast<std::ptrdiff_t>(corner.row) * view.width + corner.column,
          .stride = view.width,
          .mask = mask.rows.data(),
          .left = std::max({0, -corner.column, radius - half.column}),
          .right = std::min({2 * radius + 1, view.width - corner.column, radius + half.column + 1}),
          .top = std::max({0, -corner.row, radius - half.row}),
          .bottom = std::min({2 * radius + 1, view.height - corner.row, radius + half.row + 1}),
          .reference_per_m = view.reference_per_m,
          .ray_x = ray(from.left + corner.column, from.camera.cx, from.camera.fx),
          .ray_y = ray(from.top + corner.row, from.camera.cy, from.camera.fy),
          .ray_x_step = static_cast<float>(1.0 / from.camera.fx),
          .ray_y_step = static_cast<float>(1.0 / from.camera.fy)};
}

/// One fit over the tangent plane at `start`.
std::optional<SkinFit> fit_over(const InverseDepthView& view, const ViewCamera& from, const WindowMask& mask,
                                Pixel centre, int radius, const SkinPoint& start) {
  const double facing = facing_of(start);
  if (!(facing > kLeastFacing)) return std::nullopt;
  const double radius_px = std::max(static_cast<double>(radius), kLeastAlong_px / facing);
  const double radius_m = radius_px * start.at.z() * 2.0 / (from.camera.fx + from.camera.fy);
  const TangentFrame tangents = tangents_of(start.normal);
  const SkinFrame frame{.at = narrowed(start.at),
                        .across = narrowed(tangents.across / radius_m),
                        .down = narrowed(tangents.down / radius_m),
                        .outwards = narrowed(start.normal / radius_m)};
  SkinMoments sums;
  sum_on_skin(window_of(view, from, mask, centre, radius, half_box(start, radius_px)), frame, sums);
  if (!(sums.weight[0] > kLeastWeight)) return std::nullopt;
  const HeightEquations equations = equations_of(sums);
  std::optional<HeightTerms> terms = solve_from(0, equations);
  if (!terms) terms = solve_from(3, equations);
  if (!terms) return std::nullopt;
  const Vector3d normal = start.normal - terms->by_u * tangents.across - terms->by_v * tangents.down;
  const SkinPoint found{.at = start.at + radius_m * terms->height * start.normal, .normal = normal.normalized()};
  if (!(facing_of(found) > 0.0)) return std::nullopt;
  return SkinFit{.point = found, .gain = terms->gain};
}

}  // namespace

double facing_of(const SkinPoint& point) noexcept { return -point.normal.dot(point.at) / point.at.norm(); }

std::optional<SkinFit> fit_on_skin(const InverseDepthView& view, const ViewCamera& camera, const WindowMask& mask,
                                   Pixel centre, int radius, const SkinPoint& start) {
  SkinPoint over = start;
  for (int fits = 1;; ++fits) {
    const std::optional<SkinFit> fit = fit_over(view, camera, mask, centre, radius, over);
    if (!fit || fits == kMostFits || fit->point.normal.dot(over.normal) > kSettledCosine) return fit;
    over.normal = fit->point.normal;
    over.at *= fit->point.at.dot(over.normal) / over.at.dot(over.normal);  // stays on the ray of its pixel
  }
}

}  // namespace telepalp::surface
