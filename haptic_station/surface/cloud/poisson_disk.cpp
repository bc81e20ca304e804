#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <queue>
#include <random>

#include "haptic_station/surface/cloud/static_model.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3f;

constexpr std::size_t kOversampling = 4;

double area_of(const models::PointModel& model, const std::array<std::uint32_t, 3>& corners) {
  const Vector3f& a = model.points[corners[0]];
  return 0.5 * static_cast<double>((model.points[corners[1]] - a).cross(model.points[corners[2]] - a).norm());
}

CloudPoint point_on(const models::PointModel& model, const std::array<std::uint32_t, 3>& corners, float u, float v) {
  const float w = 1.0F - u - v;
  const Vector3f& a = model.points[corners[0]];
  const Vector3f& b = model.points[corners[1]];
  const Vector3f& c = model.points[corners[2]];
  const Vector3f face = (b - a).cross(c - a).normalized();
  if (model.normals.empty()) return {w * a + u * b + v * c, face};
  const Vector3f mixed = w * model.normals[corners[0]] + u * model.normals[corners[1]] + v * model.normals[corners[2]];
  return {w * a + u * b + v * c, mixed.norm() > 1e-6F ? mixed.normalized() : face};
}

/// The contribution of a neighbour at a distance to a point's crowding. Source: Yuksel 2015, eq. (3), alpha = 8.
double crowding(double distance, double reach) { return std::pow(1.0 - std::min(1.0, distance / reach), 8.0); }

/// Removes the most crowded of `many` points until `count` are left. `spacing_m`: the wanted spacing at each of them.
std::vector<CloudPoint> thinned(const std::vector<CloudPoint>& many, const std::vector<double>& spacing_m,
                                std::size_t count) {
  if (many.size() <= count) return many;
  // A hexagonal lattice with this distance between neighbours has one point per spacing².
  const double per_spacing = 2.0 / std::sqrt(2.0 * std::sqrt(3.0));
  IndexedPoints positions;
  for (const CloudPoint& point : many) positions.at_m.push_back(point.at_m);
  const auto index = make_nanoflann_index(positions);
  const auto crowding_of = [&](std::size_t i, const Neighbor& other) {
    const double reach = 0.5 * per_spacing * (spacing_m[i] + spacing_m[other.index]);
    return crowding(std::sqrt(static_cast<double>(other.squared_m2)), reach);
  };

  std::vector<double> crowd(many.size(), 0.0);
  std::vector<std::vector<Neighbor>> near(many.size());
  std::vector<Neighbor> found(64);
  for (std::size_t i = 0; i < many.size(); ++i) {
    const std::size_t near_by = index->within(many[i].at_m, static_cast<float>(per_spacing * spacing_m[i]), found);
    near[i].assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(near_by));
    for (const Neighbor& neighbor : near[i])
      if (neighbor.index != i) crowd[i] += crowding_of(i, neighbor);
  }
  std::priority_queue<std::pair<double, std::size_t>>
      crowded;  // an entry may be outdated; it is then updated and put back
  for (std::size_t i = 0; i < many.size(); ++i) crowded.emplace(crowd[i], i);
  std::vector<bool> gone(many.size(), false);
  for (std::size_t left = many.size(); left > count;) {
    const auto [then, i] = crowded.top();
    crowded.pop();
    if (then > crowd[i] + 1e-12) {
      crowded.emplace(crowd[i], i);
      continue;
    }
    gone[i] = true;
    --left;
    for (const Neighbor& neighbor : near[i])
      if (!gone[neighbor.index]) crowd[neighbor.index] -= crowding_of(i, neighbor);
  }
  std::vector<CloudPoint> kept;
  kept.reserve(count);
  for (std::size_t i = 0; i < many.size(); ++i)
    if (!gone[i]) kept.push_back(many[i]);
  return kept;
}

}  // namespace

std::vector<CloudPoint> face_middles(const models::PointModel& model, std::size_t count) {
  std::vector<CloudPoint> middles;
  const std::size_t stride = std::max<std::size_t>(1, model.triangles.size() / std::max<std::size_t>(1, count));
  for (std::size_t i = stride / 2; i < model.triangles.size(); i += stride)
    if (area_of(model, model.triangles[i]) > 0.0)
      middles.push_back(point_on(model, model.triangles[i], 1.0F / 3.0F, 1.0F / 3.0F));
  return middles;
}

double area_of(const models::PointModel& model) {
  double sum = 0.0;
  for (const auto& triangle : model.triangles) {
    const double area = area_of(model, triangle);
    if (std::isfinite(area)) sum += area;
  }
  return sum;
}

std::vector<CloudPoint> random_samples(const models::PointModel& model, std::size_t count, std::uint64_t seed) {
  std::vector<double> areas;
  for (const auto& triangle : model.triangles) {
    const double area = area_of(model, triangle);
    areas.push_back(std::isfinite(area) ? area : 0.0);
  }
  std::vector<CloudPoint> points;
  if (std::none_of(areas.begin(), areas.end(), [](double area) { return area > 0.0; })) return points;
  std::mt19937_64 random(seed);
  std::discrete_distribution<std::size_t> pick(areas.begin(), areas.end());
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  for (std::size_t i = 0; i < count; ++i) {
    const float root = std::sqrt(share(random));
    const float u = root * share(random);
    points.push_back(point_on(model, model.triangles[pick(random)], u, 1.0F - root));
  }
  return points;
}

std::vector<CloudPoint> poisson_disk_samples(const models::PointModel& model, std::size_t count, std::uint64_t seed) {
  const std::vector<CloudPoint> many = random_samples(model, kOversampling * count, seed);
  const double spacing_m = std::sqrt(area_of(model) / static_cast<double>(count));
  return thinned(many, std::vector<double>(many.size(), spacing_m), count);
}

std::vector<CloudPoint> graded_samples(const models::PointModel& model, const SpacingAt& spacing_m,
                                       std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  std::vector<CloudPoint> many;
  std::vector<double> spacings_m;
  for (const auto& triangle : model.triangles) {
    const double area_m2 = area_of(model, triangle);
    if (!(area_m2 > 0.0) || !std::isfinite(area_m2)) continue;
    double least_m = spacing_m(point_on(model, triangle, 1.0F / 3.0F, 1.0F / 3.0F).at_m);
    for (const std::uint32_t corner : triangle) least_m = std::min(least_m, spacing_m(model.points[corner]));
    const double wanted = static_cast<double>(kOversampling) * area_m2 / (least_m * least_m);
    const auto tries = static_cast<std::size_t>(wanted + static_cast<double>(share(random)));
    for (std::size_t i = 0; i < tries; ++i) {
      const float root = std::sqrt(share(random));
      const float u = root * share(random);
      const CloudPoint point = point_on(model, triangle, u, 1.0F - root);
      const double here_m = std::max(least_m, spacing_m(point.at_m));
      if (static_cast<double>(share(random)) * here_m * here_m > least_m * least_m) continue;
      many.push_back(point);
      spacings_m.push_back(here_m);
    }
  }
  return thinned(many, spacings_m, many.size() / kOversampling);
}

}  // namespace telepalp::surface
