#include "haptic_station/calibration/point_registration.h"

#include <Eigen/Dense>
#include <cstdio>
#include <map>
#include <string>

#include "proto/words/counted.h"

namespace telepalp::calibration {
namespace {

// A main axis counts for the rank if its standard deviation is at least both of these.
constexpr double kLeastSpread_m = 0.005;
constexpr double kLeastSpreadShare = 0.02;  // of the widest axis's standard deviation
constexpr double kLargestRmsShare = 0.1;    // largest rms residual, as a share of the widest axis's standard deviation

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kFurthestPoint_m = 10.0;
constexpr double kLargestScale = 1.25;  // sets whose sizes have a greater ratio have different units

struct Place {
  Vector3d to = Vector3d::Zero();
  Vector3d from = Vector3d::Zero();
  double repeats = 0.0;
};

Error points_refusal(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "calibration points", .fix = std::move(fix)};
}

std::string millimetres(double m) {
  char text[32];
  std::snprintf(text, sizeof text, "%ld.%ld mm", std::lround(m * 1e4) / 10, std::lround(m * 1e4) % 10);
  return text;
}

std::vector<Place> averaged(std::span<const PointPair> pairs) {
  std::map<int, Place> by_place;
  for (const PointPair& pair : pairs) {
    Place& place = by_place[pair.place];
    place.to += pair.to;
    place.from += pair.from;
    place.repeats += 1.0;
  }
  std::vector<Place> places;
  places.reserve(by_place.size());
  for (const auto& [name, place] : by_place)
    places.push_back({place.to / place.repeats, place.from / place.repeats, place.repeats});
  return places;
}

/// The points relative to their centroids; they determine the rotation.
struct Centred {
  Vector3d to_mean = Vector3d::Zero();
  Vector3d from_mean = Vector3d::Zero();
  Matrix3d from_scatter = Matrix3d::Zero();
  Matrix3d to_scatter = Matrix3d::Zero();
  Matrix3d cross = Matrix3d::Zero();  ///< to * from^T
};

Centred centred(const std::vector<Place>& places) {
  Centred c;
  const double n = static_cast<double>(places.size());
  for (const Place& place : places) {
    c.to_mean += place.to / n;
    c.from_mean += place.from / n;
  }
  for (const Place& place : places) {
    const Vector3d to = place.to - c.to_mean;
    const Vector3d from = place.from - c.from_mean;
    c.to_scatter += to * to.transpose() / n;
    c.from_scatter += from * from.transpose() / n;
    c.cross += to * from.transpose() / n;
  }
  return c;
}

/// Standard deviations along the principal directions, widest first.
Vector3d spread(const Matrix3d& scatter) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(scatter, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().reverse();
}

int rank_of(const Vector3d& widths) {
  const double least = std::max(kLeastSpread_m, kLeastSpreadShare * widths[0]);
  return static_cast<int>((widths.array() >= least).count());
}

std::string widths_text(const Vector3d& w) {
  return millimetres(w[0]) + ", " + millimetres(w[1]) + ", " + millimetres(w[2]);
}

std::optional<Error> refuse_sets(const std::vector<Place>& places, const Vector3d& to, const Vector3d& from, int rank) {
  const bool by_device = rank < 2 && to[rank] < from[rank];  // the positions by the device lack this width
  if (places.size() < 3)
    return points_refusal("only " + counted(places.size(), "different place is", "different places are") +
                              " measured (the scatter matrix of the places has rank " + std::to_string(rank) +
                              "); a rotation needs three places that are not on a line",
                          "measure at least three places, better four or more, spread over the workspace");
  if (rank < 2)
    return points_refusal(
        "the places lie " + std::string(rank == 0 ? "at one point" : "on a line") + " (rank " + std::to_string(rank) +
            " of the scatter matrix; a rotation needs rank 2): the standard deviations of the positions by the " +
            (by_device ? "device" : "tracker or camera") + " along their main axes are " +
            widths_text(by_device ? to : from),
        rank == 0 ? "spread the places over the workspace" : "add places beside the line they lie on");
  const double scale = to[0] / from[0];
  if (scale > kLargestScale || scale < 1.0 / kLargestScale)
    return points_refusal("the standard deviation of the places is " + millimetres(to[0]) +
                              " in the positions by the device, but " + millimetres(from[0]) +
                              " in those by the tracker or camera",
                          "give all positions in metres, and both positions of a place in one row");
  return std::nullopt;
}

/// The rotation nearest to `m`, of determinant 1.
Matrix3d nearest_rotation(const Matrix3d& m) {
  const Eigen::JacobiSVD<Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Matrix3d& u = svd.matrixU();
  const Matrix3d& v = svd.matrixV();
  const double sign = (u * v.transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return u * Vector3d(1.0, 1.0, sign).asDiagonal() * v.transpose();
}

Matrix3d rotation(const Centred& c, RotationBy by) {
  if (by == RotationBy::Covariance) return nearest_rotation(c.cross);
  return nearest_rotation(c.cross * c.from_scatter.inverse());
}

Residuals residuals_of(std::span<const PointPair> pairs, const Eigen::Isometry3d& to_from_from) {
  Residuals residuals;
  for (const PointPair& pair : pairs) residuals.each_m.push_back((to_from_from * pair.from - pair.to).norm());
  return residuals;
}

}  // namespace

Result<Registration> register_points(std::span<const PointPair> pairs, const RegistrationSettings& settings) {
  if (pairs.size() > kMostPairs)
    return points_refusal(std::to_string(pairs.size()) + " pairs are too many", "give at most 100000 pairs");
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (const auto far = [](const Vector3d& p) { return !p.allFinite() || p.cwiseAbs().maxCoeff() > kFurthestPoint_m; };
        far(pairs[i].to) || far(pairs[i].from))
      return points_refusal("pair " + std::to_string(i + 1) + " is not finite, or has a coordinate beyond 10 m",
                            "give positions in metres; leave out points that were not measured");

  const std::vector<Place> places = averaged(pairs);
  const Centred c = centred(places);
  const Vector3d to_widths = spread(c.to_scatter);
  const Vector3d from_widths = spread(c.from_scatter);
  const int rank = std::min(rank_of(to_widths), rank_of(from_widths));
  if (const auto error = refuse_sets(places, to_widths, from_widths, rank)) return *error;
  if (rank == 3 && c.cross.determinant() < 0.0)
    return points_refusal(
        "the positions by the device are a mirror image of those by the tracker or camera (rank 3; the determinant of "
        "their covariance is negative)",
        "check the sign of each coordinate in both sets of positions: each frame must be right-handed");
  if (settings.rotation_by == RotationBy::AffinePolar && rank < 3)
    return points_refusal(
        "the places lie in a plane (rank 2 of their scatter matrix); an affine fit needs rank 3",
        "measure places outside this plane, or fit a rotation without scale and shear, for which a plane is enough");

  Registration fit;
  fit.rank = rank;
  fit.to_from_from.linear() = rotation(c, settings.rotation_by);
  fit.to_from_from.translation() = c.to_mean - fit.to_from_from.linear() * c.from_mean;
  fit.residuals = residuals_of(pairs, fit.to_from_from);
  if (fit.residuals.rms_m() > kLargestRmsShare * from_widths[0])
    return points_refusal(
        "the pairs do not match: the RMS residual is " + millimetres(fit.residuals.rms_m()) +
            ", too much for places with a standard deviation of " + millimetres(from_widths[0]) +
            "; the worst is pair " + std::to_string(fit.residuals.worst() + 1),
        "measure the worst pair again, and check that both positions of each row belong to one place");
  return fit;
}

}  // namespace telepalp::calibration
