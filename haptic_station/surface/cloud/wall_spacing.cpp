#include "haptic_station/surface/cloud/wall_spacing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptic_station/surface/cloud/kdtree_index.h"

namespace telepalp::surface {
namespace {

constexpr double kWallPerSpacing = 2.2;  // a tenth more than two, because samples are not evenly spaced
constexpr double kGrade = kSupportGrade / kSupportPerSpacing;
constexpr int kSweeps = 12;  // each one passes a spacing on to the nearest neighbours

}  // namespace

WallSpacing::WallSpacing(const std::vector<CloudPoint>& points, double most_m, double least_m)
    : points_(points), most_m_(most_m) {
  IndexedPoints positions;
  for (const CloudPoint& point : points_) positions.at_m.push_back(point.at_m);
  index_ = make_nanoflann_index(positions);
  for (const CloudPoint& point : points_)
    spacing_m_.push_back(std::clamp(wall_m(point) / kWallPerSpacing, least_m, most_m));
  grade();
}

/// The distance through the body from a point to the samples of the opposite side, along the point's normal; infinite
/// if the body is thicker there than the widest spacing needs.
double WallSpacing::wall_m(const CloudPoint& point) const {
  const double thickest_m = kWallPerSpacing * most_m_;
  std::array<Neighbor, 128> found;
  const std::size_t count =
      index_->within(point.at_m, static_cast<float>(std::hypot(thickest_m, most_m_)), {found.data(), found.size()});
  double thinnest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    const CloudPoint& other = points_[found[i].index];
    if (other.normal.dot(point.normal) > -0.3F) continue;
    const auto deep_m = static_cast<double>((point.at_m - other.at_m).dot(point.normal));
    const double aside2_m2 = static_cast<double>(found[i].squared_m2) - deep_m * deep_m;
    if (deep_m > 0.0 && deep_m < thickest_m && aside2_m2 < most_m_ * most_m_) thinnest_m = std::min(thinnest_m, deep_m);
  }
  return thinnest_m;
}

/// Reduces spacings until each exceeds those of its neighbours by at most kGrade times the distance.
void WallSpacing::grade() {
  std::array<Neighbor, 16> found;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (spacing_m_[i] >= most_m_) continue;  // too wide to reduce a neighbour's
      const std::size_t count = index_->within(points_[i].at_m, static_cast<float>(3.0 * most_m_), found);
      for (std::size_t k = 0; k < count; ++k) {
        const double away_m = std::sqrt(static_cast<double>(found[k].squared_m2));
        double& other_m = spacing_m_[found[k].index];
        other_m = std::min(other_m, spacing_m_[i] + kGrade * away_m);
      }
    }
}

/// Each sample's spacing is used unchanged as far as the next sample, because a wall is thin between two samples of a
/// thin wall, too.
double WallSpacing::at_m(const Eigen::Vector3f& place) const {
  std::array<Neighbor, 6> found;
  const std::size_t count = index_->within(place, static_cast<float>(3.0 * most_m_), found);
  double spacing_m = most_m_;
  for (std::size_t k = 0; k < count; ++k) {
    const double beyond_m = std::max(0.0, std::sqrt(static_cast<double>(found[k].squared_m2)) - most_m_);
    spacing_m = std::min(spacing_m, spacing_m_[found[k].index] + kGrade * beyond_m);
  }
  return spacing_m;
}

double WallSpacing::samples() const {
  double count = 0.0;
  for (const double spacing_m : spacing_m_) count += (most_m_ / spacing_m) * (most_m_ / spacing_m);
  return count;
}

bool WallSpacing::differs() const {
  return std::any_of(spacing_m_.begin(), spacing_m_.end(), [&](double spacing_m) { return spacing_m < most_m_; });
}

}  // namespace telepalp::surface
