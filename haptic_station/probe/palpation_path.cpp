#include "haptic_station/probe/palpation_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "proto/words/numbers/quantile.h"
#include "support/program/files/whole_file.h"

namespace telepalp::probe {
namespace {

using Eigen::Vector3d;

constexpr double kWithin_m = 0.12;   // largest distance of a spot from the first one
constexpr double kCircle_m = 0.005;  // radius of the circle at depth

struct Spot {
  Vector3d at = Vector3d::Zero();
  Vector3d normal = Vector3d::Zero();
};

Vector3d middle_of(const std::vector<Vector3d>& points) {
  Vector3d middle = Vector3d::Zero();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const Vector3d& at : points) values.push_back(at[axis]);
    middle[axis] = median_of(values);
  }
  return middle;
}

/// The spot at a point; nullopt unless the surface covers the whole region around it that the finger touches.
std::optional<Spot> spot_at(const surface::SurfaceSnapshot& snapshot, const Vector3d& at) {
  const surface::FieldSample here = snapshot.evaluate(at, Vector3d::Zero(), {});
  if (!here.valid || here.coverage < 0.99) return std::nullopt;
  const Vector3d side = kCircle_m * here.normal.unitOrthogonal();
  const Vector3d other = here.normal.cross(side);
  for (const Vector3d& off : {side, other, Vector3d(-side), Vector3d(-other)}) {
    const surface::FieldSample there = snapshot.evaluate(at + off, here.normal, {});
    if (!there.valid || there.coverage < 0.9 || there.normal.dot(here.normal) < 0.8) return std::nullopt;
  }
  return Spot{at - here.f_m * here.normal, here.normal};
}

std::vector<Spot> choose_spots(const surface::SurfaceSnapshot& snapshot, std::vector<Vector3d> points,
                               const PalpationSettings& settings) {
  constexpr double kSameWay = 0.7;
  const Vector3d from = settings.at_m.value_or(middle_of(points));
  std::sort(points.begin(), points.end(),
            [&](const Vector3d& a, const Vector3d& b) { return (a - from).squaredNorm() < (b - from).squaredNorm(); });
  std::vector<Spot> spots;
  for (const Vector3d& at : points) {
    if (static_cast<int>(spots.size()) == settings.spots) break;
    if (!spots.empty() && (at - spots.front().at).norm() > kWithin_m) continue;
    if (std::any_of(spots.begin(), spots.end(),
                    [&](const Spot& spot) { return (at - spot.at).norm() < settings.apart_m; }))
      continue;
    const std::optional<Spot> spot = spot_at(snapshot, at);
    if (spot && (spots.empty() || spot->normal.dot(spots.front().normal) > kSameWay)) spots.push_back(*spot);
  }
  return spots;
}

/// Appends waypoints at a constant speed.
class Pen {
 public:
  explicit Pen(const PalpationSettings& settings) : settings_(settings) {}

  void move_to(const Vector3d& to) {
    if (path_.empty()) return add(to);
    const Vector3d from = path_.back().at_m;
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step_m())));
    for (int i = 1; i <= steps; ++i) add(from + (to - from) * (static_cast<double>(i) / steps));
  }

  void circle(const Vector3d& centre, const Vector3d& normal) {
    const Vector3d u = kCircle_m * normal.unitOrthogonal();
    const Vector3d v = normal.cross(u);
    move_to(centre + u);
    const double around_m = 2.0 * std::numbers::pi * kCircle_m;
    const int steps = std::max(8, static_cast<int>(around_m / step_m()));
    for (int i = 1; i <= steps; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / steps;
      add(centre + std::cos(angle) * u + std::sin(angle) * v);
    }
    move_to(centre);
  }

  [[nodiscard]] std::vector<Waypoint> path() && { return std::move(path_); }

 private:
  [[nodiscard]] double step_m() const { return settings_.speed_m_per_s / settings_.rate_hz; }
  void add(const Vector3d& at) { path_.push_back({static_cast<double>(path_.size()) / settings_.rate_hz, at}); }

  PalpationSettings settings_;
  std::vector<Waypoint> path_;
};

}  // namespace

Result<std::vector<Waypoint>> palpation_path(const surface::SurfaceSnapshot& snapshot,
                                             const std::vector<Vector3d>& on_surface,
                                             const PalpationSettings& settings) {
  const std::vector<Spot> spots =
      on_surface.empty() ? std::vector<Spot>{} : choose_spots(snapshot, on_surface, settings);
  if (spots.empty())
    return Error{
        .what =
            "the path has no spot to press: each point of the surface lies at a rim, beside a hole, or on a sharp bend",
        .where = "telepalp-probe path",
        .fix = "give a denser or larger cloud, or a depth image with fewer holes; for a cloud, check --unit-m"};
  Pen pen(settings);
  for (const Spot& spot : spots) {
    pen.move_to(spot.at + settings.above_m * spot.normal);
    const Vector3d deepest = spot.at - settings.depth_m * spot.normal;
    pen.move_to(deepest);
    pen.circle(deepest, spot.normal);
    pen.move_to(spot.at + settings.above_m * spot.normal);
  }
  return std::move(pen).path();
}

Result<void> write_trajectory(const std::filesystem::path& file, const std::vector<Waypoint>& path) {
  std::string text = "t_s,x,y,z\n";
  for (const Waypoint& waypoint : path) {
    std::array<char, 128> row{};
    std::snprintf(row.data(), row.size(), "%.9g,%.9g,%.9g,%.9g\n", waypoint.t_s, waypoint.at_m.x(), waypoint.at_m.y(),
                  waypoint.at_m.z());
    text += row.data();
  }
  return program::write_whole_file(file, text, program::Readers::Group);
}

}  // namespace telepalp::probe
