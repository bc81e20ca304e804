#include "haptic_station/calibration/rigid_fit.h"

#include <Eigen/SVD>
#include <cmath>
#include <string>

namespace telepalp::calibration {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kLeastSpread = 0.02;  // of the second direction to the first: below it, points count as on a line

Error degenerate(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "calibration", .fix = std::move(fix)};
}

Vector3d mean(std::span<const Vector3d> points) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

double squared_spread(std::span<const Vector3d> points) {
  const Vector3d middle = mean(points);
  double sum = 0.0;
  for (const Vector3d& point : points) sum += (point - middle).squaredNorm();
  return sum;
}

/// Number of directions that the points spread in, up to noise.
int rank_of(std::span<const Vector3d> points) {
  const Vector3d middle = mean(points);
  Matrix3d scatter = Matrix3d::Zero();
  for (const Vector3d& point : points) scatter += (point - middle) * (point - middle).transpose();
  const Vector3d lengths = Eigen::JacobiSVD<Matrix3d>(scatter).singularValues().cwiseSqrt();
  if (lengths[0] < 1e-6) return 0;
  return 1 + (lengths[1] > kLeastSpread * lengths[0] ? 1 : 0) + (lengths[2] > kLeastSpread * lengths[0] ? 1 : 0);
}

Result<void> check(std::span<const PointPair> pairs) {
  if (pairs.size() < 3)
    return degenerate(std::to_string(pairs.size()) + " point pairs", "record at least three, better ten, well apart");
  for (const PointPair& pair : pairs) {
    if (pair.from_m.empty() || pair.to_m.empty()) return degenerate("a pair with one side empty", "record both sides");
    for (const auto* side : {&pair.from_m, &pair.to_m})
      for (const Vector3d& point : *side)
        if (!point.allFinite()) return degenerate("a coordinate that is not finite", "record that pair again");
  }
  return {};
}

}  // namespace

Result<RigidFit> fit_rigid(std::span<const PointPair> pairs) {
  if (const Result<void> good = check(pairs); !good) return good.error();
  std::vector<Vector3d> from;
  std::vector<Vector3d> to;
  double spread = 0.0;
  double freedoms = 0.0;
  for (const PointPair& pair : pairs) {
    from.push_back(mean(pair.from_m));
    to.push_back(mean(pair.to_m));
    for (const auto* side : {&pair.from_m, &pair.to_m}) {
      spread += squared_spread(*side);
      freedoms += 3.0 * static_cast<double>(side->size() - 1);
    }
  }
  const int rank = std::min(rank_of(from), rank_of(to));
  if (rank < 2)
    return degenerate("the points are of rank " + std::to_string(rank) + (rank == 1 ? ": on a line" : ": in one place"),
                      "record points that are not on one line, and far apart");
  const Vector3d from_middle = mean(from);
  const Vector3d to_middle = mean(to);
  Matrix3d correlation = Matrix3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i)
    correlation += (to[i] - to_middle) * (from[i] - from_middle).transpose();
  const Eigen::JacobiSVD<Matrix3d> svd(correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector3d signs = Vector3d::Ones();
  const bool reflects = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0;
  if (reflects) signs[2] = -1.0;
  if (reflects && rank == 3)
    return degenerate("the two sides are mirror images", "check the axes' signs; one frame is left-handed");
  RigidFit fit;
  fit.to_from.linear() = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  fit.to_from.translation() = to_middle - fit.to_from.linear() * from_middle;
  double sum = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    fit.residuals_m.push_back((fit.to_from * from[i] - to[i]).norm());
    sum += fit.residuals_m.back() * fit.residuals_m.back();
  }
  fit.rms_residual_m = std::sqrt(sum / static_cast<double>(from.size()));
  fit.repeat_sigma_m = freedoms > 0.0 ? std::sqrt(spread / freedoms) : 0.0;
  return fit;
}

Transform<HapticBase, HandTracker> haptic_from_tracker_at(const Point<HandTracker>& hand,
                                                          const Point<HapticBase>& device) noexcept {
  Transform<HapticBase, HandTracker> out;
  out.iso.linear() = Vector3d(1.0, -1.0, -1.0).asDiagonal();
  out.iso.translation() = device.m - out.iso.linear() * hand.m;
  return out;
}

}  // namespace telepalp::calibration
