#include "haptic_station/surface/cloud/cloud_noise.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "proto/words/numbers/quantile.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double kSpacings = 3.0;
constexpr double kNoises = 4.0;
constexpr double kCurvature_per_m = 10.0;
constexpr double kDiscs = 5.0;  // a neighbourhood whose radius is this many residuals is a disc

/// Root mean square residual of a quadric through points around their mean; nullopt when they are too few.
std::optional<double> quadric_residual(const std::vector<Vector3d>& near) {
  constexpr std::size_t kFewest = 12;
  if (near.size() < kFewest) return std::nullopt;
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& at : near) mean += at / static_cast<double>(near.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& at : near) spread += (at - mean) * (at - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const double scale = std::sqrt(axes.eigenvalues()[2] / static_cast<double>(near.size()));
  if (!(scale > 0.0)) return std::nullopt;
  Eigen::Matrix<double, 6, 6> normal_matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6d right = Vector6d::Zero();
  double heights2 = 0.0;
  for (const Vector3d& at : near) {
    const Vector3d local = axes.eigenvectors().transpose() * (at - mean) / scale;  // height, then two across
    const double u = local.y(), v = local.z();
    const Vector6d row{1.0, u, v, u * u, u * v, v * v};
    normal_matrix += row * row.transpose();
    right += local.x() * row;
    heights2 += local.x() * local.x();
  }
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(normal_matrix);
  const double left = heights2 - right.dot(solver.solve(right));
  return scale * std::sqrt(std::max(0.0, left) / static_cast<double>(near.size() - 6));
}

/// The median residual of neighbourhoods of one radius; nullopt when most have too few points.
std::optional<double> residual_at(const IndexedPoints& points, const NeighborIndex& index, double radius_m) {
  constexpr std::size_t kPlaces = 300;
  constexpr std::size_t kMostNear = 4096;
  std::vector<Neighbor> found(kMostNear);
  std::vector<double> residuals;
  const std::size_t stride = std::max<std::size_t>(1, points.at_m.size() / kPlaces);
  std::size_t asked = 0;
  for (std::size_t i = 0; i < points.at_m.size(); i += stride) {
    if (!points.at_m[i].allFinite()) continue;
    ++asked;
    const std::size_t count = index.within(points.at_m[i], static_cast<float>(radius_m), found);
    std::vector<Vector3d> near;
    for (std::size_t k = 0; k < count; ++k) near.push_back(points.at_m[found[k].index].cast<double>());
    if (const auto residual = quadric_residual(near)) residuals.push_back(*residual);
  }
  if (residuals.empty() || 2 * residuals.size() < asked) return std::nullopt;
  return median_of(residuals);
}

double support_for(double spacing_m, double noise_m) {
  const double steady_m = std::cbrt(4.4 / kCurvature_per_m * noise_m * spacing_m);
  return std::max({kSpacings * spacing_m, kNoises * noise_m, steady_m});
}

}  // namespace

bool CloudNoise::follows_noise() const noexcept { return support_m > 1.01 * kSpacings * spacing_m; }

CloudNoise noise_of(const IndexedPoints& points, const NeighborIndex& index, double spacing_m) {
  constexpr double kGrowth = 1.5;
  constexpr double kWidest = 30.0;  // spacings
  CloudNoise noise{.spacing_m = spacing_m, .noise_m = 0.0, .support_m = kSpacings * spacing_m, .is_surface = true};
  for (double radius_m = noise.support_m; radius_m < kWidest * spacing_m; radius_m *= kGrowth) {
    const std::optional<double> residual = residual_at(points, index, radius_m);
    if (!residual) continue;
    noise.noise_m = *residual;
    noise.is_surface = radius_m > kDiscs * *residual;
    if (noise.is_surface) break;
  }
  noise.support_m = support_for(spacing_m, noise.noise_m);
  return noise;
}

int neighbors_in_support(const CloudNoise& noise) {
  if (!(noise.spacing_m > 0.0)) return 16;
  const double across = noise.support_m / noise.spacing_m;
  return static_cast<int>(std::clamp(std::numbers::pi * across * across, 16.0, 256.0));
}

std::string description_of(const CloudNoise& noise, std::size_t points) {
  char text[240];
  std::snprintf(text, sizeof text, "%zu points %.1f mm apart scatter by %.2f mm around their surface", points,
                1e3 * noise.spacing_m, 1e3 * noise.noise_m);
  std::string description = text;
  if (!noise.follows_noise()) return description;
  std::snprintf(text, sizeof text,
                "; because of this noise, each place is averaged over a radius of %.1f mm instead of %.1f mm",
                1e3 * noise.support_m, 1e3 * kSpacings * noise.spacing_m);
  return description + text;
}

}  // namespace telepalp::surface
