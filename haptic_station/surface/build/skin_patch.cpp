#include "haptic_station/surface/build/skin_patch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "haptic_station/surface/build/patch_terms.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSpacing_m = 0.005;  // of a patch's nodes
constexpr double kBreak_m = 0.03;     // a window over which depth differs by more is a silhouette

/// Depth and its slope by pixel, from a plane through a window.
struct Window {
  double z_m = 0.0;
  Vector2d per_px = Vector2d::Zero();
};

std::optional<Window> window_at(const DepthField& depth, const Vector2d& pixel, int half) {
  const int column = static_cast<int>(std::lround(pixel.x()));
  const int row = static_cast<int>(std::lround(pixel.y()));
  if (column < half || row < half || column + half >= depth.width || row + half >= depth.height) return std::nullopt;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Vector3d by = Vector3d::Zero();
  float low = 1e9F;
  float high = 0.0F;
  for (int v = -half; v <= half; ++v)
    for (int u = -half; u <= half; ++u) {
      const float z = depth.z_m[depth.index(column + u, row + v)];
      if (z <= 0.0F) continue;
      low = std::min(low, z);
      high = std::max(high, z);
      const Vector3d terms{1.0, static_cast<double>(u), static_cast<double>(v)};
      sum += terms * terms.transpose();
      by += static_cast<double>(z) * terms;
    }
  const int side = 2 * half + 1;
  if (sum(0, 0) < 0.7 * side * side || high - low > static_cast<float>(kBreak_m)) return std::nullopt;
  const Vector3d plane = sum.ldlt().solve(by);
  const Vector2d per_px = plane.tail<2>();
  return Window{plane[0] + per_px.dot(pixel - Vector2d(column, row)), per_px};
}

Vector3d point_at(const Intrinsics& camera, const Vector2d& pixel, double z_m) {
  return {(pixel.x() - camera.cx) / camera.fx * z_m, (pixel.y() - camera.cy) / camera.fy * z_m, z_m};
}

}  // namespace

std::optional<SkinPatch> skin_patch(const DepthField& depth, const Intrinsics& camera, const Vector3d& point,
                                    const Vector3d& up, double radius_m) {
  constexpr int kHalf_px = 6;
  SkinPatch patch;
  patch.radius_m = radius_m;
  patch.mark = point;
  for (int i = 0; i < 12; ++i) {  // along the line, to where it crosses the surface
    if (patch.mark.z() <= 0.0) return std::nullopt;
    const Vector2d pixel = pixel_of(camera, patch.mark);
    const auto seen = window_at(depth, pixel, kHalf_px);
    if (!seen) return std::nullopt;
    patch.mark = point + up.dot(point_at(camera, pixel, seen->z_m) - point) * up;
  }
  const Vector2d middle = pixel_of(camera, patch.mark);
  const double step_px = kSpacing_m * camera.fx / patch.mark.z();
  const int count = static_cast<int>(radius_m / kSpacing_m);
  Eigen::Matrix<double, 8, 8> normal = Eigen::Matrix<double, 8, 8>::Zero();
  for (int j = -count; j <= count; ++j)
    for (int i = -count; i <= count; ++i) {
      const Vector2d pixel = middle + step_px * Vector2d(i, j);
      const auto seen = window_at(depth, pixel, kHalf_px);
      if (!seen) continue;
      // dz/dx on the surface: a step of one pixel goes sideways by z / f, and by the ray's slant times dz.
      SkinPatch::Node node;
      node.at = point_at(camera, pixel, seen->z_m);
      const Vector2d ray{(pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy};
      const Vector2d by_px{seen->per_px.x() * camera.fx, seen->per_px.y() * camera.fy};
      node.slope = by_px / (seen->z_m + ray.dot(by_px));
      node.from = (node.at - patch.mark).head<2>() / radius_m;
      if (node.from.norm() > 1.0 || node.slope.norm() > 2.0) continue;
      patch.nodes.push_back(node);
      const PatchCoefficients terms = terms_of(node);
      normal += terms * terms.transpose();
      if (i == 0 && j == 0) patch.normal = Vector3d(node.slope.x(), node.slope.y(), -1.0).normalized();
    }
  if (patch.normal.isZero() || patch.nodes.size() < 200) return std::nullopt;
  patch.slide_information = slide_information(normal);
  return patch;
}

}  // namespace telepalp::surface
