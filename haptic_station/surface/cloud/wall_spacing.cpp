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

WallSpacing::WallSpacing(const std::vector<CloudPoint>& points, double most_m)
    : points_(points), most_m_(most_m), spacing_m_(points.size(), most_m) {
  IndexedPoints positions;
  for (const CloudPoint& point : points_) positions.at_m.push_back(point.at_m);
  index_ = make_nanoflann_index(positions);
  std::array<Neighbor, 16> found;
  for (const CloudPoint& point : points_) {
    wall_m_.push_back(wall_m(point));
    const std::size_t count = index_->within(point.at_m, static_cast<float>(3.0 * most_m_), found);
    near_.insert(near_.end(), found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count));
    near_end_.push_back(near_.size());
  }
}

void WallSpacing::choose(double least_m) {
  for (std::size_t i = 0; i < points_.size(); ++i)
    spacing_m_[i] = std::clamp(wall_m_[i] / kWallPerSpacing, least_m, most_m_);
  for (int sweep = 0; sweep < kSweeps && grade(); ++sweep) continue;
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

/// Reduces spacings so that each exceeds those of its nearest neighbours by at most kGrade times the distance. False if
/// none was reduced.
bool WallSpacing::grade() {
  bool reduced = false;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (spacing_m_[i] >= most_m_) continue;  // too wide to reduce a neighbour's
    for (std::size_t at = i == 0 ? 0 : near_end_[i - 1]; at < near_end_[i]; ++at) {
      const double most_m = spacing_m_[i] + kGrade * std::sqrt(static_cast<double>(near_[at].squared_m2));
      double& other_m = spacing_m_[near_[at].index];
      if (other_m <= most_m) continue;
      other_m = most_m;
      reduced = true;
    }
  }
  return reduced;
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
