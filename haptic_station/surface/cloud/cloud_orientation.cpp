#include "haptic_station/surface/cloud/cloud_orientation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <queue>
#include <random>
#include <tuple>

#include "haptic_station/surface/cloud/kdtree_index.h"
#include "haptic_station/surface/cloud/winding_number.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr std::size_t kMostPoints = 20'000;
constexpr std::size_t kNeighbors = 13;  // of each point, itself included

std::vector<CloudPoint> some_of(const std::vector<CloudPoint>& cloud) {
  std::vector<CloudPoint> some;
  std::mt19937 random(1);
  std::sample(cloud.begin(), cloud.end(), std::back_inserter(some), kMostPoints, random);
  return some;
}

std::shared_ptr<const NeighborIndex> index_over(const std::vector<CloudPoint>& points) {
  IndexedPoints positions;
  for (const CloudPoint& point : points) positions.at_m.push_back(point.at_m);
  return make_nanoflann_index(positions);
}

}  // namespace

CloudOrientation::CloudOrientation(const std::vector<CloudPoint>& cloud, double noise_m, Signs signs)
    : points_(some_of(cloud)), index_(index_over(points_)), noise_m_(noise_m) {
  const std::vector<CloudPoint> given = points_;
  propagate();
  if (signs == Signs::OfTheFile) keep_patches_of(given);
  look_for_contradictions();
  look_for_inside();
}

std::size_t CloudOrientation::neighbors_of(std::size_t point, std::vector<Neighbor>& found) const {
  found.resize(kNeighbors);
  return index_->within(points_[point].at_m, kAnywhere_m, found);
}

/// True when each of two points lies near the tangent plane of the other: not on both sides of a thin sheet.
bool CloudOrientation::are_on_one_sheet(const CloudPoint& a, const CloudPoint& b) const {
  const Vector3f between = b.at_m - a.at_m;
  const float across = std::max(std::abs(a.normal.dot(between)), std::abs(b.normal.dot(between)));
  return across < std::max(0.6F * between.norm(), 3.0F * static_cast<float>(noise_m_));
}

/// Orients a connected piece like its first point, most similar neighbours first. Returns the points that turned.
std::vector<std::size_t> CloudOrientation::propagate_from(std::size_t first, std::vector<bool>& seen) {
  using Edge = std::tuple<float, std::size_t, std::size_t>;  // similarity of the normals, to, from
  std::priority_queue<Edge> edges;
  std::vector<std::size_t> piece;
  std::vector<std::size_t> turned;
  std::vector<Neighbor> found;
  edges.emplace(1.0F, first, first);
  while (!edges.empty()) {
    const auto [similarity, to, from] = edges.top();
    edges.pop();
    if (seen[to]) continue;
    seen[to] = true;
    piece.push_back(to);
    if (points_[to].normal.dot(points_[from].normal) < 0.0F) {
      points_[to].normal = -points_[to].normal;
      turned.push_back(to);
    }
    const std::size_t count = neighbors_of(to, found);
    for (std::size_t k = 0; k < count; ++k)
      if (!seen[found[k].index] && are_on_one_sheet(points_[to], points_[found[k].index]))
        edges.emplace(std::abs(points_[to].normal.dot(points_[found[k].index].normal)), found[k].index, to);
  }
  if (2 * turned.size() <= piece.size()) return turned;
  for (const std::size_t point : piece) points_[point].normal = -points_[point].normal;  // the majority is right
  std::vector<std::size_t> kept;
  std::sort(piece.begin(), piece.end());
  std::sort(turned.begin(), turned.end());
  std::set_difference(piece.begin(), piece.end(), turned.begin(), turned.end(), std::back_inserter(kept));
  return kept;
}

void CloudOrientation::propagate() {
  std::vector<bool> seen(points_.size(), false);
  std::size_t turned = 0;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!seen[i]) turned += propagate_from(i, seen).size();
  against_ = points_.empty() ? 0.0 : static_cast<double>(turned) / static_cast<double>(points_.size());
}

/// Whether the turned point `here` fits the oriented point `there`: 1 on a smooth surface, -1 on the two sides of a
/// thin wall, 0 if their normals differ too much to say.
int CloudOrientation::fits_beside(const CloudPoint& here, const CloudPoint& there) const {
  constexpr float kSmooth = 0.9F;   // cosine of 26 degrees
  constexpr float kOnSheet = 0.2F;  // on a round surface, the offset at this angle divided by the distance
  if (here.normal.dot(there.normal) < kSmooth) return 0;
  const Vector3f between = there.at_m - here.at_m;
  const float across = std::max(std::abs(here.normal.dot(between)), std::abs(there.normal.dot(between)));
  return across < std::max(kOnSheet * between.norm(), 3.0F * static_cast<float>(noise_m_)) ? 1 : -1;
}

/// Collects the patch of neighbours that turned together with `first`. True when it is bounded by others, and turning
/// it does not make it fit them.
bool CloudOrientation::is_bounded_by_edges(std::size_t first, const std::vector<CloudPoint>& given,
                                           std::vector<bool>& seen, std::vector<std::size_t>& patch) const {
  patch.assign(1, first);
  seen[first] = true;
  bool is_bounded = false;
  int fitting = 0;
  std::vector<Neighbor> found;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    const CloudPoint& here = points_[patch[i]];
    const std::size_t count = neighbors_of(patch[i], found);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t there = found[k].index;
      const int fits = fits_beside(here, points_[there]);
      if (points_[there].normal.dot(given[there].normal) > 0.0F) {
        is_bounded = true;
        fitting += fits - fits_beside({here.at_m, -here.normal}, points_[there]);
      } else if (fits > 0 && !seen[there]) {
        seen[there] = true;
        patch.push_back(there);
      }
    }
  }
  return is_bounded && fitting <= 0;
}

void CloudOrientation::keep_patches_of(const std::vector<CloudPoint>& given) {
  std::vector<bool> seen(points_.size(), false);
  std::vector<std::size_t> kept;
  std::vector<std::size_t> patch;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const bool is_turned = points_[i].normal.dot(given[i].normal) < 0.0F;
    if (is_turned && !seen[i] && is_bounded_by_edges(i, given, seen, patch))
      kept.insert(kept.end(), patch.begin(), patch.end());
  }
  for (const std::size_t point : kept) points_[point].normal = given[point].normal;
  if (!points_.empty()) against_ -= static_cast<double>(kept.size()) / static_cast<double>(points_.size());
}

void CloudOrientation::look_for_contradictions() {
  constexpr float kClear = 0.5F;
  std::size_t pairs = 0;
  std::size_t opposite = 0;
  std::vector<Neighbor> found;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t count = neighbors_of(i, found);
    for (std::size_t k = 0; k < count; ++k) {
      const float cosine = points_[i].normal.dot(points_[found[k].index].normal);
      if (found[k].index == i || std::abs(cosine) < kClear || !are_on_one_sheet(points_[i], points_[found[k].index]))
        continue;
      ++pairs;
      opposite += cosine < 0.0F ? 1U : 0U;
    }
  }
  contradictions_ = pairs == 0 ? 1.0 : static_cast<double>(opposite) / static_cast<double>(pairs);
}

/// The winding number is 1 below and 0 above a closed surface with outward normals, 0 below and -1 above one with
/// inward normals, and one half below and minus one half above an open sheet: their sum tells the three apart.
void CloudOrientation::look_for_inside() {
  constexpr double kCertain = 0.85;  // a half ball, open below, reaches 0.7
  constexpr std::size_t kPlaces = 300;
  if (points_.size() < kNeighbors) return;
  std::vector<double> areas_m2;
  std::vector<Neighbor> found;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t count = neighbors_of(i, found);
    float farthest2 = 0.0F;
    for (std::size_t k = 0; k < count; ++k) farthest2 = std::max(farthest2, found[k].squared_m2);
    areas_m2.push_back(std::numbers::pi * static_cast<double>(farthest2) / static_cast<double>(kNeighbors - 1));
  }
  const WindingNumber winding(points_, areas_m2);
  double sum = 0.0;
  std::size_t places = 0;
  for (std::size_t i = 0; i < points_.size(); i += std::max<std::size_t>(1, points_.size() / kPlaces)) {
    const Vector3d off = std::max(1.5 * std::sqrt(areas_m2[i]), 3.0 * noise_m_) * points_[i].normal.cast<double>();
    const Vector3d at = points_[i].at_m.cast<double>();
    sum += winding.at(at - off) + winding.at(at + off);
    ++places;
  }
  turns_ = sum / static_cast<double>(places);
  closed_ = std::abs(turns_) > kCertain;
  if (closed_ && turns_ < 0.0)
    for (CloudPoint& point : points_) point.normal = -point.normal;
}

/// Compares a point with the nearest oriented point of its sheet; false when none is near.
bool CloudOrientation::points_against(const CloudPoint& point) const {
  constexpr float kClear = 0.5F;
  std::array<Neighbor, 6> near;
  const std::size_t count = index_->within(point.at_m, kAnywhere_m, near);
  float nearest2 = kAnywhere_m;
  bool against = false;
  for (std::size_t k = 0; k < count; ++k) {
    const CloudPoint& oriented = points_[near[k].index];
    const float cosine = oriented.normal.dot(point.normal);
    const bool same_sheet = std::abs(cosine) > kClear && are_on_one_sheet(oriented, point);
    if (near[k].squared_m2 >= nearest2 || (near[k].squared_m2 > 0.0F && !same_sheet)) continue;
    nearest2 = near[k].squared_m2;
    against = cosine < 0.0F;
  }
  return against;
}

double CloudOrientation::share_against(const std::vector<CloudPoint>& cloud) const {
  const auto against =
      std::count_if(cloud.begin(), cloud.end(), [&](const CloudPoint& p) { return points_against(p); });
  return cloud.empty() ? 0.0 : static_cast<double>(against) / static_cast<double>(cloud.size());
}

void CloudOrientation::apply(std::vector<CloudPoint>& cloud) const {
  for (CloudPoint& point : cloud)
    if (points_against(point)) point.normal = -point.normal;
}

}  // namespace telepalp::surface
