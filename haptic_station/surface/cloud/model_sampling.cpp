#include "haptic_station/surface/cloud/model_sampling.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "haptic_station/surface/cloud/wall_spacing.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kFewestSamples = 16'000;  // S2's mannequin had as many

struct Sampler {
  const models::PointModel& mesh;
  const StaticModelSettings& settings;
  const Vector3d& origin_m;
  float side;
  double area_m2;
  MeshJudge judge;

  [[nodiscard]] SampledMesh operator()(std::size_t count) const {
    say_count(count);
    CloudShape shape;
    shape.support_m = settings.support_m;
    const double spacing_m = std::sqrt(area_m2 / static_cast<double>(count));
    return touched(poisson_disk_samples(mesh, count, settings.seed), shape, spacing_m, spacing_m);
  }
  /// Samples the mesh again, with `spacing`, which is denser at thin walls. `sampled`: the mesh with an even spacing.
  [[nodiscard]] SampledMesh denser_at_walls(const SampledMesh& sampled, const WallSpacing& spacing,
                                            double least_m) const {
    say_count(static_cast<std::size_t>(spacing.samples()));
    CloudShape shape;
    shape.support_m = kSupportPerSpacing * sampled.spacing_m;
    shape.graded = true;
    const auto spacing_at = [&](const Eigen::Vector3f& place) { return spacing.at_m(place); };
    std::vector<CloudPoint> points = graded_samples(mesh, spacing_at, settings.seed);
    for (CloudPoint& point : points)
      point.support_m = static_cast<float>(kSupportPerSpacing * spacing.at_m(point.at_m));
    return touched(std::move(points), shape, sampled.spacing_m, least_m);
  }
  [[nodiscard]] std::size_t count_for(double spacing_m) const {
    const double count = area_m2 / (spacing_m * spacing_m);
    return static_cast<std::size_t>(std::clamp(count, 100.0, 1e6));
  }

 private:
  void say_count(std::size_t count) const {
    if (settings.on_progress)
      settings.on_progress("spreading " + std::to_string(count) + " points over the mesh, and testing the surface");
  }
  [[nodiscard]] SampledMesh touched(std::vector<CloudPoint> points, CloudShape shape, double spacing_m,
                                    double least_m) const {
    for (CloudPoint& point : points) point.normal *= side;
    const double hidden = judge.leave_out_hidden(points);
    shape.origin_m = origin_m;
    SampledMesh sampled{std::make_shared<const CloudSnapshot>(std::move(points), shape, Index::Nanoflann),
                        spacing_m,
                        least_m,
                        hidden,
                        {},
                        {}};
    sampled.fidelity = judge.judge(*sampled.snapshot);
    return sampled;
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

/// `sampled`, with denser samples at thin walls. The spacing at the thinnest walls is the smallest one, from 0.2 mm on,
/// for which kMostSamples suffice. Returns `sampled` unchanged if no wall is thin, or no such spacing is found.
SampledMesh denser_at_walls(const Sampler& sampler, SampledMesh sampled) {
  constexpr double kLeast_m = 0.0002;
  constexpr double kCoarser = 1.2;
  WallSpacing spacing(sampled.snapshot->cloud(), sampled.spacing_m);
  for (double least_m = kLeast_m; least_m < sampled.spacing_m; least_m *= kCoarser) {
    spacing.choose(least_m);
    if (!spacing.differs()) break;
    if (spacing.samples() <= static_cast<double>(kMostSamples))
      return sampler.denser_at_walls(sampled, spacing, least_m);
  }
  return sampled;
}

SampledMesh sampled_as_asked(const Sampler& sampler) {
  if (sampler.settings.samples > 0) return sampler(sampler.settings.samples);
  if (sampler.settings.spacing_m > 0.0) return sampler(sampler.count_for(sampler.settings.spacing_m));
  SampledMesh sampled = refined(sampler);
  return sampler.settings.support_m > 0.0 ? sampled : denser_at_walls(sampler, std::move(sampled));
}

/// "; 12 % of the surface has walls thinner than two spacings, ... : 2.3 mm at (0.01, 0.02, 0.3) m"
std::string description_of(const ThinWalls& thin) {
  if (thin.share < 0.001) return "";
  char text[240];
  std::snprintf(text, sizeof text,
                "; %.1f %% of the surface has walls thinner than two spacings, where the contact can jump to the other "
                "side: ",
                100.0 * thin.share);
  std::string description = text;
  for (std::size_t i = 0; i < thin.places.size(); ++i) {
    const ThinWalls::Place& place = thin.places[i];
    std::snprintf(text, sizeof text, "%sunder %.1f mm at (%.3f, %.3f, %.3f) m", i == 0 ? "" : ", ", 1e3 * place.wall_m,
                  place.at_m.x(), place.at_m.y(), place.at_m.z());
    description += text;
  }
  return description;
}

}  // namespace

SampledMesh sample_mesh(const models::PointModel& mesh, const StaticModelSettings& settings, const Vector3d& origin_m,
                        float side) {
  const Sampler sampler{mesh, settings, origin_m, side, area_of(mesh), MeshJudge(mesh, side, settings.seed + 1)};
  if (!sampler.judge.has_places()) return {};
  SampledMesh sampled = sampled_as_asked(sampler);
  sampled.fidelity.jumps = sampler.judge.share_of_jumps(*sampled.snapshot);
  sampled.thin = sampler.judge.thin_walls(*sampled.snapshot, sampled.spacing_m);
  for (ThinWalls::Place& place : sampled.thin.places) place.at_m += origin_m;
  return sampled;
}

bool is_too_coarse(const Fidelity& fidelity) noexcept {
  return fidelity.error_m > kTooCoarse_m || (fidelity.in_air > kMostInAir && fidelity.in_air < kOverlap) ||
         fidelity.missing > kMostMissing;
}

std::string description_of(const SampledMesh& sampled) {
  char text[240];
  std::string from;
  if (sampled.least_spacing_m < sampled.spacing_m) {
    std::snprintf(text, sizeof text, "%.1f to ", 1e3 * sampled.least_spacing_m);
    from = text;
  }
  std::snprintf(text, sizeof text,
                "%u points %s%.1f mm apart: the surface felt lies within %.1f mm of the mesh in 99 of 100 places",
                sampled.snapshot->points, from.c_str(), 1e3 * sampled.spacing_m, 1e3 * sampled.fidelity.error_m);
  std::string description = text;
  if (sampled.hidden > 0.001) {
    std::snprintf(text, sizeof text, "; %.0f %% of the mesh lies inside other parts of it and is left out",
                  std::max(1.0, 100.0 * sampled.hidden));
    description += text;
  }
  if (sampled.fidelity.missing > 0.001) {
    std::snprintf(text, sizeof text, "; in %.1f %% of the tested places on the mesh no contact is felt",
                  100.0 * sampled.fidelity.missing);
    description += text;
  }
  if (sampled.fidelity.in_air > 0.0) {
    std::snprintf(text, sizeof text,
                  "; in %.2f %% of the places 3 to 15 mm above the mesh, contact is felt in free air%s",
                  100.0 * sampled.fidelity.in_air,
                  sampled.fidelity.in_air < kOverlap ? "" : ": parts of the mesh overlap or face inwards");
    description += text;
  }
  if (sampled.fidelity.jumps > 0.0) {
    std::snprintf(text, sizeof text,
                  "; in %.1f %% of the simulated presses, the contact jumps from one wall of a fold to the other",
                  100.0 * sampled.fidelity.jumps);
    description += text;
  }
  return description + description_of(sampled.thin);
}

}  // namespace telepalp::surface
