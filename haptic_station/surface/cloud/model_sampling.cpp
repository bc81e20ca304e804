#include "haptic_station/surface/cloud/model_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "haptic_station/surface/touch/touch.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kFewestSamples = 16'000;  // S2's mannequin had as many
constexpr std::size_t kProbedPlaces = 2'000;    // test points drawn by area; as many are drawn by face

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
  const TouchSample sample = touch.step({at}, SessionTime{}, 0.0005);
  return sample.valid && sample.in_body;
}

/// The share of points with a false contact, among points above the mesh that are not near another part of it.
double share_in_air(const CloudSnapshot& snapshot, const std::vector<CloudPoint>& places, float side,
                    const NeighborIndex& mesh) {
  constexpr float kHeights_m[] = {0.003F, 0.008F, 0.015F};
  constexpr float kFree = 0.8F;  // a test point's distance from the mesh is at least this share of its height
  std::size_t free = 0;
  std::size_t touched = 0;
  for (const CloudPoint& place : places)
    for (const float height_m : kHeights_m) {
      const Eigen::Vector3f at = place.at_m + side * height_m * place.normal;
      std::array<Neighbor, 1> nearest;
      if (mesh.within(at, kFree * height_m, nearest) > 0) continue;
      ++free;
      if (is_touched(snapshot, snapshot.shape().origin_m + at.cast<double>())) ++touched;
    }
  return free == 0 ? 0.0 : static_cast<double>(touched) / static_cast<double>(free);
}

/// The error at the points `places` of the mesh, each approached from its own side.
Fidelity fidelity_of(const CloudSnapshot& snapshot, const std::vector<CloudPoint>& places, float side,
                     const NeighborIndex* mesh) {
  std::vector<double> errors;
  for (const CloudPoint& place : places) {
    const Vector3d at = snapshot.shape().origin_m + place.at_m.cast<double>();
    const FieldSample here = snapshot.evaluate(at, side * place.normal.cast<double>(), {});
    if (here.valid) errors.push_back(std::abs(here.f_m));
  }
  if (errors.empty()) return {.error_m = 0.0, .missing = 1.0, .in_air = 0.0};
  const auto worst = errors.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(errors.size()));
  std::nth_element(errors.begin(), worst, errors.end());
  return {.error_m = *worst,
          .missing = 1.0 - static_cast<double>(errors.size()) / static_cast<double>(places.size()),
          .in_air = mesh == nullptr ? 0.0 : share_in_air(snapshot, places, side, *mesh)};
}

struct Sampler {
  const models::PointModel& mesh;
  const StaticModelSettings& settings;
  const Vector3d& origin_m;
  float side;
  double area_m2;
  std::vector<CloudPoint> places;
  std::shared_ptr<const NeighborIndex> near_mesh;  // nullptr: false contacts are not counted

  [[nodiscard]] SampledMesh operator()(std::size_t count) const {
    std::vector<CloudPoint> points = poisson_disk_samples(mesh, count, settings.seed);
    for (CloudPoint& point : points) point.normal *= side;
    CloudShape shape;
    shape.origin_m = origin_m;
    shape.support_m = settings.support_m;
    SampledMesh sampled{std::make_shared<const CloudSnapshot>(std::move(points), shape, Index::Nanoflann),
                        std::sqrt(area_m2 / static_cast<double>(count)),
                        {}};
    sampled.fidelity = fidelity_of(*sampled.snapshot, places, side, near_mesh.get());
    return sampled;
  }
  [[nodiscard]] std::size_t count_for(double spacing_m) const {
    const double count = area_m2 / (spacing_m * spacing_m);
    return static_cast<std::size_t>(std::clamp(count, 100.0, 1e6));
  }
};

/// Increases the number of samples while that reduces the error. Two errors remain at any density: that of normals that
/// do not fit the faces, and false contacts at a mesh that overlaps itself.
SampledMesh refined(const Sampler& sampler) {
  constexpr double kPays = 0.7;  // a refinement must reduce the error at least to this share
  SampledMesh sampled = sampler(kFewestSamples);
  Fidelity before{.error_m = 1.0, .missing = 1.0, .in_air = 1.0};
  for (std::size_t count = kFewestSamples; count < kMostSamples;) {
    const Fidelity found = sampled.fidelity;
    const bool nearer = found.error_m > kFaithful_m && found.error_m < kPays * before.error_m;
    const bool freer = found.in_air > 0.0 && found.in_air < std::min(kOverlap, kPays * before.in_air);
    if (!nearer && !freer) break;
    before = found;
    count = std::min(kMostSamples, static_cast<std::size_t>(std::clamp(found.error_m / kFaithful_m, 2.0, 4.0) *
                                                            static_cast<double>(count)));
    sampled = sampler(count);
  }
  return sampled;
}

}  // namespace

SampledMesh sample_mesh(const models::PointModel& mesh, const StaticModelSettings& settings, const Vector3d& origin_m,
                        float side, bool closed) {
  std::vector<CloudPoint> places = random_samples(mesh, kProbedPlaces, settings.seed + 1);
  const std::vector<CloudPoint> fine = face_middles(mesh, kProbedPlaces);
  places.insert(places.end(), fine.begin(), fine.end());
  const Sampler sampler{
      mesh, settings, origin_m, side, area_of(mesh), std::move(places), closed ? index_of(mesh) : nullptr};
  if (sampler.places.empty()) return {};
  if (settings.samples > 0) return sampler(settings.samples);
  if (settings.spacing_m > 0.0) return sampler(sampler.count_for(settings.spacing_m));
  return refined(sampler);
}

bool is_too_coarse(const Fidelity& fidelity) noexcept {
  return fidelity.error_m > kTooCoarse_m || (fidelity.in_air > kMostInAir && fidelity.in_air < kOverlap) ||
         fidelity.missing > kMostMissing;
}

std::string description_of(const SampledMesh& sampled) {
  char text[240];
  std::snprintf(text, sizeof text,
                "%u points %.1f mm apart: the surface felt lies within %.1f mm of the mesh in 99 of 100 places",
                sampled.snapshot->points, 1e3 * sampled.spacing_m, 1e3 * sampled.fidelity.error_m);
  std::string description = text;
  if (sampled.fidelity.missing > 0.001) {
    std::snprintf(text, sizeof text, "; in %.1f %% there is nothing to touch", 100.0 * sampled.fidelity.missing);
    description += text;
  }
  if (sampled.fidelity.in_air > 0.0) {
    std::snprintf(text, sizeof text, "; in %.2f %% of the places 3 to 15 mm above it, contact is felt in free air%s",
                  100.0 * sampled.fidelity.in_air,
                  sampled.fidelity.in_air < kOverlap ? "" : ": parts of the mesh overlap or look inwards");
    description += text;
  }
  return description;
}

}  // namespace telepalp::surface
