#include "haptic_station/surface/cloud/winding_number.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kLeaf = 8;
constexpr double kFar = 3.5;  // a group farther away than this many of its radii is summed as one dipole

/// The solid angle of a triangle as a share of the whole sphere. Source: Van Oosterom and Strackee 1983.
double winding_of(const std::array<Vector3d, 3>& corners, const Vector3d& query) {
  const Vector3d a = corners[0] - query;
  const Vector3d b = corners[1] - query;
  const Vector3d c = corners[2] - query;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double around = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return std::atan2(a.dot(b.cross(c)), around) / (2.0 * std::numbers::pi);
}

double winding_of_dipole(const Vector3d& area, const Vector3d& from_query) {
  const double distance2 = from_query.squaredNorm();
  if (!(distance2 > 0.0)) return 0.0;
  return area.dot(from_query) / (4.0 * std::numbers::pi * distance2 * std::sqrt(distance2));
}

}  // namespace

WindingNumber::WindingNumber(const models::PointModel& mesh) {
  for (const auto& at : mesh.triangles) {
    const std::array<Vector3d, 3> corners = {mesh.points[at[0]].cast<double>(), mesh.points[at[1]].cast<double>(),
                                             mesh.points[at[2]].cast<double>()};
    const Vector3d area = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (!(area.squaredNorm() > 0.0) || !area.allFinite()) continue;
    const Vector3d centre = (corners[0] + corners[1] + corners[2]) / 3.0;
    double radius = 0.0;
    for (const Vector3d& corner : corners) radius = std::max(radius, (corner - centre).norm());
    patches_.push_back({centre, area, radius, static_cast<std::uint32_t>(corners_.size())});
    corners_.push_back(corners);
  }
  build();
}

WindingNumber::WindingNumber(const std::vector<CloudPoint>& cloud, const std::vector<double>& areas_m2) {
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (areas_m2[i] > 0.0)
      patches_.push_back({cloud[i].at_m.cast<double>(), areas_m2[i] * cloud[i].normal.cast<double>(), 0.0, 0});
  build();
}

void WindingNumber::build() {
  if (!patches_.empty()) add_node(0, static_cast<std::uint32_t>(patches_.size()));
}

WindingNumber::Patch WindingNumber::sum_of(std::uint32_t from, std::uint32_t to) const {
  Patch sum;
  double areas = 0.0;
  for (std::uint32_t i = from; i < to; ++i) {
    const double area = patches_[i].area.norm();
    areas += area;
    sum.area += patches_[i].area;
    sum.centre += area * patches_[i].centre;
  }
  sum.centre /= areas;
  for (std::uint32_t i = from; i < to; ++i)
    sum.radius = std::max(sum.radius, (patches_[i].centre - sum.centre).norm() + patches_[i].radius);
  return sum;
}

/// Splits at the median of the longest axis. Returns the node's number.
std::uint32_t WindingNumber::add_node(std::uint32_t from, std::uint32_t to) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({sum_of(from, to), from, to, 0, 0});
  if (to - from <= kLeaf) return number;
  Eigen::AlignedBox3d box;
  for (std::uint32_t i = from; i < to; ++i) box.extend(patches_[i].centre);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::uint32_t middle = from + (to - from) / 2;
  std::nth_element(patches_.begin() + from, patches_.begin() + middle, patches_.begin() + to,
                   [&](const Patch& a, const Patch& b) { return a.centre[axis] < b.centre[axis]; });
  const std::uint32_t left = add_node(from, middle);
  const std::uint32_t right = add_node(middle, to);
  nodes_[number].left = left;
  nodes_[number].right = right;
  return number;
}

double WindingNumber::of_patch(const Patch& patch, const Vector3d& query) const {
  if (corners_.empty()) return winding_of_dipole(patch.area, patch.centre - query);
  return winding_of(corners_[patch.triangle], query);
}

double WindingNumber::at(const Vector3d& query) const {
  double sum = 0.0;
  std::vector<std::uint32_t> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const Node& node = nodes_[open.back()];
    open.pop_back();
    const Vector3d away = node.sum.centre - query;
    if (away.norm() > kFar * node.sum.radius) {
      sum += winding_of_dipole(node.sum.area, away);
    } else if (node.left == 0) {
      for (std::uint32_t i = node.from; i < node.to; ++i) sum += of_patch(patches_[i], query);
    } else {
      open.push_back(node.left);
      open.push_back(node.right);
    }
  }
  return sum;
}

}  // namespace telepalp::surface
