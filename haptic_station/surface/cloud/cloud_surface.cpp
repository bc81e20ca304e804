#include "haptic_station/surface/cloud/cloud_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptic_station/surface/snapshot/soft_object_weight.h"
#include "proto/words/smooth_step.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostNeighbors = 256;

/// Weight of a point by the angle between its normal and `facing`: 1 up to 60 degrees, 0 from 90 degrees.
double side_weight(const Vector3d& normal, const Vector3d& facing) noexcept {
  if (facing.isZero()) return 1.0;
  return smooth_step(2.0 * normal.dot(facing));
}

struct Sums {
  double weight = 0.0;
  double plane = 0.0;
  Vector3d normal = Vector3d::Zero();
  Vector3d offset = Vector3d::Zero();
  Vector3d weight_by = Vector3d::Zero();
  Vector3d plane_by = Vector3d::Zero();
  Eigen::Matrix3d normal_by = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d offset_by = Eigen::Matrix3d::Zero();
};

void add(Sums& sums, const Vector3d& offset, const Vector3d& normal, double side, double per_r2) noexcept {
  const Weight fade = soft_object_weight(offset.squaredNorm() * per_r2);
  const double w = side * fade.value;
  if (w <= 0.0) return;
  const Vector3d by = (2.0 * per_r2 * side * fade.slope) * offset;
  const double plane = normal.dot(offset);
  sums.weight += w;
  sums.plane += w * plane;
  sums.normal += w * normal;
  sums.offset += w * offset;
  sums.weight_by += by;
  sums.plane_by += plane * by;
  sums.normal_by += normal * by.transpose();
  sums.offset_by += offset * by.transpose();
}

/// Coverage at a point, from the sum of weights. A sum below the constant is the outer rim of a single point's support,
/// where the coverage fades to 0.
double coverage_of_weight(double weight) noexcept {
  constexpr double kLeast = 0.02;
  constexpr double kWhole = 0.30;
  return smooth_step(kLeast, kWhole, weight);
}

FieldSample sample_of(const Sums& sums) noexcept {
  FieldSample out;
  out.coverage = coverage_of_weight(sums.weight);
  const double length = sums.normal.norm();
  if (out.coverage <= 0.0 || length < 1e-3 * sums.weight) return {};
  const Vector3d n = sums.normal / length;
  out.valid = true;
  out.normal = n;
  out.f_m = 0.5 * (sums.plane + n.dot(sums.offset)) / sums.weight;
  const Vector3d turn = (sums.offset - n.dot(sums.offset) * n) / length;
  const Vector3d rise = sums.normal + sums.weight * n + sums.plane_by + sums.offset_by.transpose() * n +
                        sums.normal_by.transpose() * turn - 2.0 * out.f_m * sums.weight_by;
  out.gradient = 0.5 * rise / sums.weight;
  return out;
}

}  // namespace

std::optional<Neighbor> CloudSurface::nearest(const Eigen::Vector3f& local, double within_m) const noexcept {
  std::array<Neighbor, 1> found;
  if (index_->within(local, static_cast<float>(within_m), found) == 0) return std::nullopt;
  return found[0];
}

/// A point of support h at the distance r has a weight if r < h. The grade of the supports bounds h by
/// h0 + kSupportGrade (r + d0), where h0 and d0 are the nearest point's support and distance.
double CloudSurface::reach_m(const Eigen::Vector3f& local) const noexcept {
  if (!shape_.graded) return shape_.support_m;
  const std::optional<Neighbor> near = nearest(local, shape_.support_m);
  if (!near) return 0.0;
  const double away_m = std::sqrt(static_cast<double>(near->squared_m2));
  const auto support_m = static_cast<double>(points_[near->index].support_m);
  return std::min(shape_.support_m, (support_m + kSupportGrade * away_m) / (1.0 - kSupportGrade));
}

FieldSample CloudSurface::evaluate(const Vector3d& query, const Vector3d& facing,
                                   const MotionBasis& /*a model stands still*/) const noexcept {
  if (index_ == nullptr || !query.allFinite()) return {};
  const Vector3d local = query - shape_.origin_m;
  std::array<Neighbor, kMostNeighbors> found;
  const std::size_t most = shape_.neighbors > 0 ? std::min(shape_.neighbors, kMostNeighbors) : kMostNeighbors;
  const Eigen::Vector3f at = local.cast<float>();
  const double reach = reach_m(at);
  const std::size_t count = index_->within(at, static_cast<float>(reach), {found.data(), most});
  double support2 = reach * reach;
  if (count == most) {  // the k-th neighbour has weight zero, so f does not jump without the (k + 1)-th
    support2 = 0.0;
    for (std::size_t i = 0; i < count; ++i) support2 = std::max(support2, static_cast<double>(found[i].squared_m2));
  }
  if (support2 <= 0.0) return {};
  Sums sums;
  for (std::size_t i = 0; i < count; ++i) {
    const CloudPoint& point = points_[found[i].index];
    const Vector3d normal = point.normal.cast<double>();
    const auto own_m = static_cast<double>(point.support_m);
    const double per_r2 = 1.0 / (shape_.graded ? std::min(support2, own_m * own_m) : support2);
    add(sums, local - point.at_m.cast<double>(), normal, side_weight(normal, facing), per_r2);
  }
  return sample_of(sums);
}

std::optional<Seed> CloudSurface::seed(const Vector3d& query) const noexcept {
  if (index_ == nullptr || !query.allFinite()) return std::nullopt;
  const Vector3d local = query - shape_.origin_m;
  const std::optional<Neighbor> near = nearest(local.cast<float>(), shape_.seed_radius_m);
  if (!near) return std::nullopt;
  const CloudPoint& point = points_[near->index];
  const Vector3d at = point.at_m.cast<double>();
  return Seed{shape_.origin_m + at, point.normal.cast<double>().dot(local - at) >= 0.0};
}

double CloudSurface::stride_m(const Vector3d& query) const noexcept {
  constexpr double kShare = 0.4;
  if (!shape_.graded) return kShare * shape_.support_m;
  const std::optional<Neighbor> near = nearest((query - shape_.origin_m).cast<float>(), shape_.support_m);
  return kShare * (near ? static_cast<double>(points_[near->index].support_m) : shape_.support_m);
}

}  // namespace telepalp::surface
