#include "haptic_station/surface/build/patch_registration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Coefficients = Eigen::Matrix<double, 8, 1>;  // slide along x and y, then the rise's polynomial

constexpr double kRadius_m = 0.13;    // of the patch
constexpr double kSpacing_m = 0.005;  // of its nodes
constexpr double kMiddle_m = 0.02;    // around the mark, where the rise must be seen
constexpr double kBreak_m = 0.03;     // a window over which depth differs by more is a silhouette
constexpr int kLooks = 2;             // how often the residuals are computed again from the image
constexpr int kReweighted = 2;        // reweighted fits to each set of residuals
constexpr double kFirstScale_m = 0.01;
constexpr double kLeastNoise_m = 0.0005;
constexpr double kTogether = 9.0;  // errors of neighbouring nodes are correlated: this many nodes count as one

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

Vector2d pixel_of(const Intrinsics& camera, const Vector3d& at) {
  return {camera.fx * at.x() / at.z() + camera.cx, camera.fy * at.y() / at.z() + camera.cy};
}

Vector3d point_at(const Intrinsics& camera, const Vector2d& pixel, double z_m) {
  return {(pixel.x() - camera.cx) / camera.fx * z_m, (pixel.y() - camera.cy) / camera.fy * z_m, z_m};
}

Coefficients terms_of(const SkinPatch::Node& node) {
  const double x = node.from.x();
  const double y = node.from.y();
  Coefficients terms;
  terms << -node.slope.x(), -node.slope.y(), 1.0, x, y, x * x, x * y, y * y;
  return terms;
}

double tukey(double residual_m, double scale_m) {
  const double u = residual_m / (4.7 * scale_m);
  return u * u >= 1.0 ? 0.0 : (1.0 - u * u) * (1.0 - u * u);
}

double median_magnitude(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  return std::abs(*middle);
}

/// Information matrix of the slide after the rise's polynomial is marginalised out (Schur complement).
Eigen::Matrix2d slide_information(const Eigen::Matrix<double, 8, 8>& normal) {
  const Eigen::Matrix<double, 6, 6> rise = normal.bottomRightCorner<6, 6>();
  return normal.topLeftCorner<2, 2>() -
         normal.topRightCorner<2, 6>() * rise.ldlt().solve(normal.bottomLeftCorner<6, 2>());
}

double sigma_of(const Eigen::Matrix2d& information, double noise_m) {
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(information).eigenvalues()[0];
  return noise_m * std::sqrt(kTogether / std::max(least, 1e-9));
}

/// One node's residual: measured minus expected depth, and the derivatives of the expected depth by the coefficients.
struct Residual {
  double m = 0.0;
  Coefficients terms;
  bool in_middle = false;
};

/// Mean depth of the window around `pixel`, extrapolated to `pixel` with the slope `per_px`. 0: not measured.
double depth_at(const DepthField& depth, const Vector2d& pixel, const Vector2d& per_px) {
  constexpr int kHalf_px = 2;
  constexpr int kLeast_px = 18;
  const int column = static_cast<int>(std::lround(pixel.x()));
  const int row = static_cast<int>(std::lround(pixel.y()));
  if (column < kHalf_px || row < kHalf_px || column + kHalf_px >= depth.width || row + kHalf_px >= depth.height)
    return 0.0;
  double sum = 0.0;
  Vector2d at = Vector2d::Zero();
  int count = 0;
  for (int v = row - kHalf_px; v <= row + kHalf_px; ++v)
    for (int u = column - kHalf_px; u <= column + kHalf_px; ++u) {
      const float z = depth.z_m[depth.index(u, v)];
      if (z <= 0.0F) continue;
      sum += static_cast<double>(z);
      at += Vector2d(u, v);
      ++count;
    }
  return count < kLeast_px ? 0.0 : sum / count + per_px.dot(pixel - at / count);
}

/// Fills `residuals` for the motion `found`. Returns the number of nodes in the patch's middle.
int look_at(const SkinPatch& patch, const DepthField& depth, const Intrinsics& camera, const Coefficients& found,
            std::vector<Residual>& residuals) {
  residuals.clear();
  int middle_nodes = 0;
  for (const SkinPatch::Node& node : patch.nodes) {
    Residual seen{.m = 0.0, .terms = terms_of(node), .in_middle = node.from.norm() * kRadius_m < kMiddle_m};
    middle_nodes += seen.in_middle ? 1 : 0;
    const Vector3d expected = node.at + Vector3d(found[0], found[1], seen.terms.tail<6>().dot(found.tail<6>()));
    const double m_per_px = expected.z() / camera.fx;
    const double z_m = depth_at(depth, pixel_of(camera, expected), node.slope * m_per_px);
    if (z_m <= 0.0) continue;
    seen.m = z_m - expected.z();
    residuals.push_back(seen);
  }
  return middle_nodes;
}

/// The weighted normal equations once the expectation has changed by `change`, with weights for `scale_m`.
struct Fit {
  double scale_m = 0.0;  ///< 1-sigma of the residuals, from their median
  Eigen::Matrix<double, 8, 8> normal = Eigen::Matrix<double, 8, 8>::Identity() * 1e-6;
  Coefficients by = Coefficients::Zero();
  double middle_weight = 0.0;
  double middle_m = 0.0;  ///< mean residual in the patch's middle
};

Fit fitted(const std::vector<Residual>& residuals, const Coefficients& change, double scale_m) {
  Fit fit;
  std::vector<double> left_m;
  left_m.reserve(residuals.size());
  for (const Residual& one : residuals) {
    const double m = one.m - one.terms.dot(change);
    left_m.push_back(m);
    const double weight = tukey(m, scale_m);
    if (weight <= 0.0) continue;
    fit.normal.noalias() += weight * one.terms * one.terms.transpose();
    fit.by += weight * m * one.terms;
    if (!one.in_middle) continue;
    fit.middle_weight += weight;
    fit.middle_m += weight * m;
  }
  fit.middle_m /= std::max(1.0, fit.middle_weight);
  fit.scale_m = std::max(kLeastNoise_m, 1.4826 * median_magnitude(std::move(left_m)));
  return fit;
}

}  // namespace

std::optional<SkinPatch> skin_patch(const DepthField& depth, const Intrinsics& camera, const Vector3d& point,
                                    const Vector3d& up) {
  constexpr int kHalf_px = 6;
  SkinPatch patch;
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
  const int count = static_cast<int>(kRadius_m / kSpacing_m);
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
      node.from = (node.at - patch.mark).head<2>() / kRadius_m;
      if (node.from.norm() > 1.0 || node.slope.norm() > 2.0) continue;
      patch.nodes.push_back(node);
      const Coefficients terms = terms_of(node);
      normal += terms * terms.transpose();
      if (i == 0 && j == 0) patch.normal = Vector3d(node.slope.x(), node.slope.y(), -1.0).normalized();
    }
  if (patch.normal.isZero() || patch.nodes.size() < 200) return std::nullopt;
  patch.slide_information = slide_information(normal);
  return patch;
}

PatchPose registered(const SkinPatch& patch, const DepthField& depth, const Intrinsics& camera, const PatchPose& start,
                     bool slides) {
  PatchPose pose = start;
  pose.seen = false;
  Coefficients found = Coefficients::Zero();
  found.head<2>() = start.slide_m;
  found[2] = start.deeper_m;
  std::vector<Residual> residuals;
  residuals.reserve(patch.nodes.size());
  Fit fit{.scale_m = kFirstScale_m};
  for (int look = 0; look < kLooks; ++look) {
    const int middle_nodes = look_at(patch, depth, camera, found, residuals);
    const Coefficients seen_from = found;
    for (int i = 0; i < kReweighted; ++i) {
      fit = fitted(residuals, found - seen_from, fit.scale_m);
      if (2.0 * fit.middle_weight < middle_nodes || middle_nodes == 0) return pose;
      if (slides)
        found += fit.normal.ldlt().solve(fit.by);
      else  // the slide is given: only the rise is found
        found.tail<6>() += fit.normal.bottomRightCorner<6, 6>().ldlt().solve(fit.by.tail<6>());
    }
    fit = fitted(residuals, found - seen_from, fit.scale_m);
  }
  pose.seen = true;
  pose.slide_m = found.head<2>();
  pose.deeper_m = found[2] + fit.middle_m;
  pose.sigma_depth_m = fit.scale_m * std::sqrt(kTogether / std::max(1.0, fit.middle_weight));
  pose.sigma_slide_m = sigma_of(slide_information(fit.normal), fit.scale_m);
  return pose;
}

}  // namespace telepalp::surface
