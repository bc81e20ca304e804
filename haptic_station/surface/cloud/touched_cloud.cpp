#include "haptic_station/surface/cloud/touched_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <random>
#include <utility>

#include "haptic_station/surface/cloud/cloud_noise.h"
#include "haptic_station/surface/cloud/cloud_orientation.h"
#include "proto/words/numbers/quantile.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kFew = 0.005;  // share of the normals: at thin sheets, the orientation found is wrong for as many

template <class... Values>
std::string text(const char* format, Values... values) {
  std::array<char, 320> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

/// The finite points with their normals; zero where the file gives none.
std::vector<CloudPoint> finite_points(const models::PointModel& cloud) {
  std::vector<CloudPoint> points;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const bool usable = cloud.normals.empty() || (cloud.normals[i].allFinite() && cloud.normals[i].norm() > 0.5F);
    if (!cloud.points[i].allFinite() || !usable) continue;
    points.push_back({cloud.points[i], cloud.normals.empty() ? Vector3f(Vector3f::Zero()) : cloud.normals[i]});
  }
  return points;
}

/// The median angle between given normals and normals that are estimated from the points, at up to 1000 points.
double misfit_deg(const std::vector<CloudPoint>& points, const NeighborIndex& index, int neighbors) {
  std::vector<double> angles;
  std::vector<Neighbor> found(static_cast<std::size_t>(neighbors));
  const std::size_t stride = std::max<std::size_t>(1, points.size() / 1000);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const std::size_t count = index.within(points[i].at_m, 1e6F, found);
    std::vector<Vector3f> near;
    for (std::size_t k = 0; k < count; ++k) near.push_back(points[found[k].index].at_m);
    const std::optional<Vector3f> fitted = normal_of(near);
    if (fitted) angles.push_back(std::acos(std::min(1.0F, std::abs(fitted->dot(points[i].normal)))) * 180.0 / M_PI);
  }
  if (angles.empty()) return 0.0;
  return median_of(angles);
}

Error too_noisy(const CloudNoise& noise) {
  const std::string what =
      noise.is_surface
          ? text(
                "is too noisy to be touched: its points are %.1f mm apart and scatter by %.1f mm around "
                "their surface, so each place would be averaged over a radius of %.0f mm, which hides smaller features",
                1e3 * noise.spacing_m, 1e3 * noise.noise_m, 1e3 * noise.support_m)
          : text("is not a surface: its points are %.1f mm apart and fill a volume", 1e3 * noise.spacing_m);
  return {.what = what,
          .where = "model",
          .fix = "filter or average the points, give a mesh, or accept the cloud by --anyway"};
}

Error no_side(const std::string& what) {
  return {.what = what + "; the cloud is open, so it is not known which side is outside",
          .where = "model",
          .fix =
              "give normals that fit the points and all point outwards; or give --anyway if the camera was at the "
              "origin of the file's frame: telepalp then estimates normals that face the camera"};
}

/// A cloud while its normals are settled.
struct Settling {
  const StaticModelSettings& settings;
  const CloudNoise& noise;
  Vector3f viewpoint;  ///< relative to the cloud's middle
  std::vector<CloudPoint> points;
  std::string remarks;
  bool closed = false;
};

void estimate_normals(Settling& cloud) {
  const int neighbors = std::max(cloud.settings.normal_neighbors, neighbors_in_support(cloud.noise));
  add_remark(cloud.remarks,
             text("each normal is estimated from %d neighbouring points and turned towards the origin of the "
                  "file's frame, where the camera is assumed",
                  neighbors));
  cloud.points = with_normals(positions_of(cloud.points).at_m, neighbors, cloud.viewpoint);
}

double share_away(const Settling& cloud) {
  const auto away = std::count_if(cloud.points.begin(), cloud.points.end(), [&](const CloudPoint& point) {
    return point.normal.dot(cloud.viewpoint - point.at_m) < 0.0F;
  });
  return static_cast<double>(away) / static_cast<double>(std::max<std::size_t>(1, cloud.points.size()));
}

/// Reverses normals of a closed cloud that point inwards.
void turn_outwards(Settling& cloud, const CloudOrientation& orientation, const char* whose) {
  const double inwards = orientation.share_against(cloud.points);
  if (inwards < kFew) return;
  if (inwards > 1.0 - kFew)
    for (CloudPoint& point : cloud.points) point.normal = -point.normal;
  else
    orientation.apply(cloud.points);
  add_remark(cloud.remarks, text("the cloud is closed and %.1f %% of %s normals pointed inwards: they are reversed",
                                 100.0 * inwards, whose));
}

/// Normals of the file that fit the points, of an open cloud.
Result<void> settle_open(Settling& cloud, const CloudOrientation& orientation) {
  constexpr double kMostMended = 0.1;
  constexpr double kHollow = -0.1;  // a bowl that is touched from inside has this winding number, or less
  const double against = orientation.against_neighbors();
  if (against > kMostMended || (against > kFew && !orientation.is_consistent())) {
    const std::string what = text("%.0f %% of the normals contradict their neighbours", 100.0 * against);
    if (!cloud.settings.anyway) return no_side("has normals that point to different sides of the surface: " + what);
    add_remark(cloud.remarks, what);
    estimate_normals(cloud);
    return {};
  }
  if (against > kFew) {
    orientation.apply(cloud.points);
    add_remark(cloud.remarks,
               text("%.1f %% of the normals contradicted their neighbours: they are reversed", 100.0 * against));
  }
  if (orientation.turns() < kHollow && !cloud.settings.flip_normals)
    add_remark(
        cloud.remarks,
        "the normals of the open cloud point to its concave side: if that is not the outside, give --flip-normals, or "
        "flip_normals in a scene");
  const double away = share_away(cloud);
  if (away > 0.9 && !cloud.settings.flip_normals)
    add_remark(
        cloud.remarks,
        text("the cloud is open and %.0f %% of its normals point away from the origin of the file's frame: if the "
             "camera was at this origin, give --flip-normals, or flip_normals in a scene",
             100.0 * away));
  return {};
}

Result<void> settle_normals(Settling& cloud, bool given, double misfit) {
  constexpr double kMostMisfit_deg = 20.0;
  const bool fit = given && misfit < kMostMisfit_deg;
  const std::string unfit = text(
      "has normals that do not fit its points: at the median they differ by %.0f degrees from normals that are "
      "estimated from the points",
      misfit);
  if (given && !fit) add_remark(cloud.remarks, "the cloud " + unfit);
  if (!given) add_remark(cloud.remarks, "the cloud has no normals");
  if (!fit) estimate_normals(cloud);
  using Signs = CloudOrientation::Signs;
  const CloudOrientation orientation(cloud.points, cloud.noise.noise_m, fit ? Signs::OfTheFile : Signs::Guessed);
  cloud.closed = orientation.is_closed();
  if (cloud.closed) {
    turn_outwards(cloud, orientation, fit ? "its" : "the estimated");
    return {};
  }
  if (fit) return settle_open(cloud, orientation);
  if (given && !cloud.settings.anyway) return no_side(unfit);
  return {};
}

/// Keeps so many points that the support holds about 200 of them: the most that a tick sums.
void thin_for(double support_m, double spacing_m, std::vector<CloudPoint>& points) {
  const double across = support_m / std::max(1e-9, spacing_m);
  constexpr double kMostAcross = 8.0;
  if (across <= kMostAcross) return;
  const double share = (kMostAcross / across) * (kMostAcross / across);
  std::vector<CloudPoint> kept;
  std::mt19937 random(1);
  std::sample(points.begin(), points.end(), std::back_inserter(kept),
              static_cast<std::size_t>(share * static_cast<double>(points.size())), random);
  points = std::move(kept);
}

}  // namespace

Result<StaticModel> touched_cloud(const models::PointModel& cloud, const StaticModelSettings& settings,
                                  const Vector3d& origin_m) {
  std::vector<CloudPoint> points = finite_points(cloud);
  if (points.empty()) return no_surface();
  const IndexedPoints at = positions_of(points);
  const auto index = make_nanoflann_index(at);
  const CloudNoise noise = noise_of(at, *index, spacing_m(points, *index));
  const bool untouchable = !noise.is_surface || (noise.follows_noise() && noise.support_m > kWidestSupport_m);
  if (untouchable && !settings.anyway) return too_noisy(noise);
  const bool given = !cloud.normals.empty();
  const double misfit = given ? misfit_deg(points, *index, neighbors_in_support(noise)) : 0.0;
  Settling settling{settings, noise, (settings.viewpoint_m - origin_m).cast<float>(), std::move(points), {}};
  if (const auto settled = settle_normals(settling, given, misfit); !settled) return settled.error();
  if (settling.points.empty()) return no_surface();
  if (settings.flip_normals && settling.closed) {
    if (!settings.anyway) return inside_out("cloud");
    add_remark(settling.remarks, touched_from_inside("cloud"));
  }
  if (settings.flip_normals)
    for (CloudPoint& point : settling.points) point.normal = -point.normal;
  CloudShape shape;
  shape.origin_m = origin_m;
  shape.support_m = settings.support_m > 0.0 ? settings.support_m : noise.support_m;
  StaticModel made{.snapshot = nullptr, .remarks = settling.remarks, .sampling = {}};
  made.sampling = description_of(noise, settling.points.size());
  const std::size_t given_points = settling.points.size();
  if (settings.support_m <= 0.0) thin_for(shape.support_m, noise.spacing_m, settling.points);
  if (settling.points.size() < given_points)
    add_remark(made.sampling,
               text("%zu of the points, chosen at random, are kept, so that the 2 kHz control loop has time to "
                    "average the points around the device point",
                    settling.points.size()));
  made.snapshot = std::make_shared<const CloudSnapshot>(std::move(settling.points), shape, Index::Nanoflann);
  return made;
}

}  // namespace telepalp::surface
