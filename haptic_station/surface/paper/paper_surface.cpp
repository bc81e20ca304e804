#include "haptic_station/surface/paper/paper_surface.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptic_station/surface/snapshot/soft_object_weight.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr std::size_t kMostNeighbors = 4096;

Vector3d towards_camera(const Vector3d& normal, const Vector3d& at) noexcept {
  return normal.dot(at) > 0.0 ? Vector3d(-normal) : normal;
}

/// Normal of a neighbourhood by principal component analysis; the direction to the camera if the points are collinear
/// or coincide.
Vector3d principal_normal(const Eigen::Matrix3d& covariance, const Vector3d& at) noexcept {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const Vector3d spread = solver.eigenvalues();
  if (!(spread[1] > 1e-4 * spread[2]) || !(spread[2] > 0.0)) return -at.normalized();
  return towards_camera(solver.eigenvectors().col(0), at);
}

}  // namespace

PaperSurface::PaperSurface(IndexedPoints cloud, const SurfaceSettings& settings)
    : points_(std::move(cloud)),
      index_(make_index(settings.index, points_)),
      most_neighbors_(std::clamp<std::size_t>(static_cast<std::size_t>(settings.neighbors), 3, kMostNeighbors)),
      radius_m_(settings.radius_m) {
  index_name = index_->name();
  points = static_cast<std::uint32_t>(
      std::count_if(points_.at_m.begin(), points_.at_m.end(), [](const Vector3f& at) { return at.allFinite(); }));
}

std::size_t PaperSurface::neighbors_of(const Vector3f& query, std::span<Neighbor> found) const noexcept {
  return index_->within(query, static_cast<float>(radius_m_), found.first(std::min(found.size(), most_neighbors_)));
}

Vector3d PaperSurface::normal_at(const Vector3f& point) const noexcept {
  std::array<Neighbor, kMostNeighbors> found;
  const std::size_t count = neighbors_of(point, found);
  Vector3d mean = Vector3d::Zero();
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d from = (points_.at_m[found[i].index] - point).cast<double>();
    mean += from;
    square += from * from.transpose();
  }
  const double per = 1.0 / static_cast<double>(std::max<std::size_t>(count, 1));
  return principal_normal(per * square - (per * mean) * (per * mean).transpose(), point.cast<double>());
}

FieldSample PaperSurface::evaluate(
    const Vector3d& query, const Vector3d& /*facing*/,
    const MotionBasis& /*the paper's surface stands still between frames*/) const noexcept {
  if (!query.allFinite()) return {};
  std::array<Neighbor, kMostNeighbors> found;
  const std::size_t count = neighbors_of(query.cast<float>(), found);
  double weights = 0.0;
  Vector3d offset = Vector3d::Zero();
  Vector3d normal = Vector3d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3f& at = points_.at_m[found[i].index];
    const Vector3d from = query - at.cast<double>();
    const double w = soft_object_weight(from.squaredNorm() / (radius_m_ * radius_m_)).value;
    weights += w;
    offset += w * from;
    normal += w * normal_at(at);
  }
  const double length = normal.norm();
  if (!(weights > 1e-12) || !(length > 1e-12)) return {};
  FieldSample out;
  out.valid = true;
  out.normal = out.gradient = normal / length;
  out.f_m = out.normal.dot(offset) / weights;
  out.coverage = 1.0;
  return out;
}

std::optional<Seed> PaperSurface::seed(const Vector3d& query) const noexcept {
  if (!query.allFinite()) return std::nullopt;
  std::array<Neighbor, 1> nearest;
  if (index_->within(query.cast<float>(), static_cast<float>(radius_m_), nearest) == 0) return std::nullopt;
  const Vector3f& at = points_.at_m[nearest[0].index];
  return Seed{at.cast<double>(), normal_at(at).dot(query - at.cast<double>()) >= 0.0};
}

double PaperSurface::stride_m(const Vector3d& /*query*/) const noexcept { return 0.1 * radius_m_; }

IndexedPoints to_points(const DepthField& depth, const Intrinsics& camera) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  IndexedPoints points{.at_m = {}, .width = depth.width};
  points.at_m.reserve(depth.z_m.size());
  for (int row = 0; row < depth.height; ++row)
    for (int column = 0; column < depth.width; ++column) {
      const double z = depth.z_m[depth.index(column, row)];
      points.at_m.push_back(z > 0.0
                                ? Vector3d((column - camera.cx) / camera.fx * z, (row - camera.cy) / camera.fy * z, z)
                                      .cast<float>()
                                      .eval()
                                : Vector3f::Constant(kNone).eval());
    }
  return points;
}

}  // namespace telepalp::surface
