#include "haptic_station/surface/cloud/model_fidelity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptic_station/surface/cloud/static_model.h"
#include "haptic_station/surface/touch/touch.h"
#include "proto/words/numbers/quantile.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kProbedPlaces = 2'000;  // test points drawn by area; as many are drawn by face
constexpr double kTick_s = 0.0005;

/// An index of the mesh's vertices and triangle centres. It gives the distance of a point from the mesh within a few
/// millimetres.
std::shared_ptr<const NeighborIndex> index_of(const models::PointModel& mesh) {
  IndexedPoints points;
  points.at_m = mesh.points;
  for (const auto& at : mesh.triangles)
    points.at_m.push_back((mesh.points[at[0]] + mesh.points[at[1]] + mesh.points[at[2]]) / 3.0F);
  std::erase_if(points.at_m, [](const Eigen::Vector3f& at) { return !at.allFinite(); });
  return make_nanoflann_index(points);
}

/// True when a hand that moves to `at` feels contact there.
bool is_touched(const CloudSnapshot& snapshot, const Vector3d& at) {
  TouchSettings settings;
  settings.gentle_start = false;
  Touch touch(settings);
  touch.adopt(snapshot, SessionTime{});
  const TouchSample sample = touch.step({at}, SessionTime{}, kTick_s);
  return sample.valid && sample.in_body;
}

/// True when the proxy jumps under a hand that presses 2 mm deep at `at`, against `out`, and slides 5 mm to the side.
bool jumps_in_press(const CloudSnapshot& snapshot, const Vector3d& at, const Vector3d& out) {
  constexpr double kStep_m = 5e-5;
  constexpr double kJump_m = 4e-4;
  constexpr int kSteps = 100;  // down, and as many to the side
  const Vector3d side = out.unitOrthogonal();
  Touch touch;
  touch.adopt(snapshot, SessionTime{});
  Vector3d last = Vector3d::Zero();  // from hand to proxy
  for (int i = 0; i <= 2 * kSteps; ++i) {
    const double down_m = kStep_m * std::min(i, kSteps);
    const Vector3d hand = at + (0.003 - down_m) * out + kStep_m * std::max(0, i - kSteps) * side;
    const Vector3d pulled = touch.step({hand}, SessionTime{}, kTick_s).proxy.m - hand;
    if (i > 0 && (pulled - last).norm() > kJump_m) return true;
    last = pulled;
  }
  return false;
}

}  // namespace

MeshJudge::MeshJudge(const models::PointModel& mesh, float side, std::uint64_t seed)
    : side_(side), winding_(mesh), near_(index_of(mesh)), places_(random_samples(mesh, kProbedPlaces, seed)) {
  std::vector<CloudPoint> fine = face_middles(mesh, kProbedPlaces);
  for (std::vector<CloudPoint>* drawn : {&places_, &fine}) {
    for (CloudPoint& place : *drawn) place.normal *= side;
    leave_out_hidden(*drawn);
  }
  by_area_ = places_.size();
  places_.insert(places_.end(), fine.begin(), fine.end());
}

bool MeshJudge::encloses(const Vector3d& at) const { return static_cast<double>(side_) * winding_.at(at) > 0.5; }

double MeshJudge::leave_out_hidden(std::vector<CloudPoint>& points) const {
  constexpr double kAbove_m = 1e-4;
  const auto before = static_cast<double>(points.size());
  std::erase_if(points, [&](const CloudPoint& point) {
    return encloses(point.at_m.cast<double>() + kAbove_m * point.normal.cast<double>());
  });
  return before > 0.0 ? 1.0 - static_cast<double>(points.size()) / before : 0.0;
}

/// The share of points with a false contact, among points above the mesh that are not near another part of it.
double MeshJudge::share_in_air(const CloudSnapshot& snapshot) const {
  constexpr float kHeights_m[] = {0.003F, 0.008F, 0.015F};
  constexpr float kFree = 0.8F;  // a test point's distance from the mesh is at least this share of its height
  std::size_t free = 0;
  std::size_t touched = 0;
  for (const CloudPoint& place : places_)
    for (const float height_m : kHeights_m) {
      const Eigen::Vector3f at = place.at_m + height_m * place.normal;
      std::array<Neighbor, 1> nearest;
      if (near_->within(at, kFree * height_m, nearest) > 0 || encloses(at.cast<double>())) continue;
      ++free;
      if (is_touched(snapshot, snapshot.shape().origin_m + at.cast<double>())) ++touched;
    }
  return free == 0 ? 0.0 : static_cast<double>(touched) / static_cast<double>(free);
}

Fidelity MeshJudge::judge(const CloudSnapshot& snapshot) const {
  std::vector<double> errors;
  for (const CloudPoint& place : places_) {
    const Vector3d at = snapshot.shape().origin_m + place.at_m.cast<double>();
    const FieldSample here = snapshot.evaluate(at, place.normal.cast<double>(), {});
    if (here.valid) errors.push_back(std::abs(here.f_m));
  }
  if (errors.empty()) return {.error_m = 0.0, .missing = 1.0, .in_air = 0.0, .jumps = 0.0};
  return {.error_m = quantile_of(errors, 0.99),
          .missing = 1.0 - static_cast<double>(errors.size()) / static_cast<double>(places_.size()),
          .in_air = share_in_air(snapshot),
          .jumps = 0.0};
}

/// The thickness of the body below the place, in steps of an eighth of `below_m`; infinite if it is not less than
/// `below_m`, or if the mesh does not enclose what is below.
double MeshJudge::wall_m(const CloudPoint& place, double below_m) const {
  constexpr double kEnclosed = 0.8;  // below an open sheet the winding number is one half
  constexpr double kJustBelow_m = 1e-4;
  constexpr int kSteps = 8;
  const Vector3d at = place.at_m.cast<double>();
  const Vector3d in = -place.normal.cast<double>();
  if (static_cast<double>(side_) * winding_.at(at + kJustBelow_m * in) > kEnclosed)
    for (int i = 1; i <= kSteps; ++i)
      if (const double deep_m = below_m * i / kSteps; !encloses(at + deep_m * in)) return deep_m;
  return std::numeric_limits<double>::infinity();
}

ThinWalls MeshJudge::thin_walls(const CloudSnapshot& snapshot, double spacing_m) const {
  constexpr double kApart_m = 0.02;
  constexpr std::size_t kMostPlaces = 3;
  std::vector<ThinWalls::Place> thin;
  for (std::size_t i = 0; i < by_area_; ++i)
    if (const double thick_m = wall_m(places_[i], 2.0 * snapshot.spacing_at_m(places_[i].at_m, spacing_m));
        std::isfinite(thick_m))
      thin.push_back({places_[i].at_m.cast<double>(), thick_m});
  std::sort(thin.begin(), thin.end(), [](const auto& a, const auto& b) { return a.wall_m < b.wall_m; });
  ThinWalls walls;
  if (by_area_ > 0) walls.share = static_cast<double>(thin.size()) / static_cast<double>(by_area_);
  for (const ThinWalls::Place& place : thin) {
    const bool is_apart = std::all_of(walls.places.begin(), walls.places.end(), [&](const ThinWalls::Place& kept) {
      return (kept.at_m - place.at_m).norm() > kApart_m;
    });
    if (walls.places.size() < kMostPlaces && is_apart) walls.places.push_back(place);
  }
  return walls;
}

/// True when the place is free above, and the body is thicker than the press at both ends of the slide.
bool MeshJudge::can_be_pressed(const CloudPoint& place) const {
  const Vector3d at = place.at_m.cast<double>();
  const Vector3d out = place.normal.cast<double>();
  const Vector3d beside = at + 0.005 * out.unitOrthogonal();
  if (encloses(at + 0.005 * out)) return false;
  const double depths_m[] = {0.003, 0.006, 0.01};
  return std::all_of(std::begin(depths_m), std::end(depths_m),
                     [&](double depth_m) { return encloses(at - depth_m * out) && encloses(beside - depth_m * out); });
}

double MeshJudge::share_of_jumps(const CloudSnapshot& snapshot) const {
  constexpr std::size_t kMostPresses = 300;
  const std::size_t stride = std::max<std::size_t>(1, places_.size() / kMostPresses);
  std::size_t pressed = 0;
  std::size_t jumped = 0;
  for (std::size_t i = 0; i < places_.size(); i += stride) {
    const CloudPoint& place = places_[i];
    if (!can_be_pressed(place)) continue;
    ++pressed;
    const Vector3d at = snapshot.shape().origin_m + place.at_m.cast<double>();
    if (jumps_in_press(snapshot, at, place.normal.cast<double>())) ++jumped;
  }
  return pressed == 0 ? 0.0 : static_cast<double>(jumped) / static_cast<double>(pressed);
}

}  // namespace telepalp::surface
