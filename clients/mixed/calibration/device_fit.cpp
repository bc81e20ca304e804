#include "clients/mixed/calibration/device_fit.h"

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <set>

#include "proto/words/rotation_vector.h"

namespace telepalp::mixed {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kLeastRingSpread_m = 0.005;  // standard deviation of the places along their second main axis
constexpr int kSteps = 6;

Error clicks_refusal(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "clicks", .fix = std::move(fix)};
}

Matrix3Xd rings_of(std::span<const Click> clicks) {
  Matrix3Xd rings(3, static_cast<Eigen::Index>(clicks.size()));
  for (std::size_t i = 0; i < clicks.size(); ++i) rings.col(static_cast<Eigen::Index>(i)) = clicks[i].ring.m;
  return rings;
}

Matrix3Xd tips_of(const DeviceModel& model, const GimbalError& error, std::span<const Click> clicks) {
  Matrix3Xd tips(3, static_cast<Eigen::Index>(clicks.size()));
  for (std::size_t i = 0; i < clicks.size(); ++i)
    tips.col(static_cast<Eigen::Index>(i)) = tip_of(model, corrected(model, error, clicks[i].readings_rad));
  return tips;
}

bool is_finite(const Click& click) {
  bool finite = click.ring.m.allFinite();
  for (const double angle_rad : click.readings_rad) finite = finite && std::isfinite(angle_rad);
  return finite;
}

/// Standard deviation along the second main axis [m]: 0 for places on a line.
double second_spread_m(const Matrix3Xd& points) {
  const Matrix3Xd centred = points.colwise() - points.rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      centred * centred.transpose() / static_cast<double>(points.cols()), Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(solver.eigenvalues()[1], 0.0));
}

Result<void> check(const DeviceModel& model, std::span<const Click> clicks) {
  std::set<int> places;
  for (std::size_t i = 0; i < clicks.size(); ++i) {
    if (clicks[i].readings_rad.size() != model.joints.size() || !is_finite(clicks[i]))
      return clicks_refusal("click " + std::to_string(i + 1) + " is not complete: it takes a ring and " +
                                std::to_string(model.joints.size()) + " joint angles, all finite",
                            "click again, or remove the row");
    places.insert(clicks[i].place);
  }
  if (places.size() < 3)
    return clicks_refusal(
        "only " + std::to_string(places.size()) + " different places were clicked; a pose needs three",
        "click at three places or more that are not on a line");
  if (second_spread_m(rings_of(clicks)) < kLeastRingSpread_m)
    return clicks_refusal(
        "the places lie on a line: across it their standard deviation is below 5 mm, so the rotation about "
        "it is unknown",
        "click at places beside the line");
  return {};
}

/// The unknowns of the fit: a small motion of the pose, and the gimbal's coefficients.
struct Estimate {
  Eigen::Isometry3d world_from_haptic;
  GimbalError error;
  Vector3d centre_m;  ///< the small motion turns about this point of the world's frame

  [[nodiscard]] Estimate moved(const VectorXd& by) const {
    Estimate next = *this;
    const Eigen::Isometry3d turn = isometry_of(by.head<3>(), Vector3d::Zero());
    next.world_from_haptic =
        Eigen::Translation3d(centre_m + by.segment<3>(3)) * turn * Eigen::Translation3d(-centre_m) * world_from_haptic;
    for (std::size_t i = 0; i < next.error.coefficients_rad.size(); ++i)
      next.error.coefficients_rad[i] += by[static_cast<Eigen::Index>(6 + i)];
    return next;
  }
};

/// Tips minus rings, divided by kClickDeviation_m; then the gimbal's coefficients, divided by kGimbalDeviations_rad.
VectorXd residuals_of(const DeviceModel& model, std::span<const Click> clicks, const Estimate& at) {
  const Matrix3Xd off = at.world_from_haptic * tips_of(model, at.error, clicks) - rings_of(clicks);
  const auto terms = static_cast<Eigen::Index>(at.error.coefficients_rad.size());
  VectorXd residuals(off.size() + terms);
  residuals.head(off.size()) = off.reshaped() / kClickDeviation_m;
  for (Eigen::Index i = 0; i < terms; ++i)
    residuals[off.size() + i] = at.error.coefficients_rad[static_cast<std::size_t>(i)] /
                                kGimbalDeviations_rad[static_cast<std::size_t>(i) % GimbalError::kTermsAJoint];
  return residuals;
}

MatrixXd jacobian_of(const DeviceModel& model, std::span<const Click> clicks, const Estimate& at) {
  constexpr double kStep = 1e-5;
  const auto unknowns = static_cast<Eigen::Index>(6 + at.error.coefficients_rad.size());
  MatrixXd jacobian;
  for (Eigen::Index k = 0; k < unknowns; ++k) {
    const VectorXd step = kStep * VectorXd::Unit(unknowns, k);
    const VectorXd column =
        (residuals_of(model, clicks, at.moved(step)) - residuals_of(model, clicks, at.moved(-step))) / (2.0 * kStep);
    if (k == 0) jacobian.resize(column.size(), unknowns);
    jacobian.col(k) = column;
  }
  return jacobian;
}

void add_distances(DeviceFit& fit, const VectorXd& distances_m) {
  fit.mean_m = distances_m.mean();
  fit.rms_m = std::sqrt(distances_m.squaredNorm() / static_cast<double>(distances_m.size()));
  fit.deviation_m = std::sqrt(std::max(0.0, fit.rms_m * fit.rms_m - fit.mean_m * fit.mean_m));
  Eigen::Index worst = 0;
  fit.largest_m = distances_m.maxCoeff(&worst);
  fit.worst = static_cast<std::size_t>(worst);
}

}  // namespace

Result<DeviceFit> fit_device(const DeviceModel& model, std::span<const Click> clicks, GimbalFit gimbal) {
  if (const Result<void> usable = check(model, clicks); !usable) return usable.error();
  const Matrix3Xd rings = rings_of(clicks);
  Estimate at{.world_from_haptic = {}, .error = {}, .centre_m = rings.rowwise().mean()};
  at.world_from_haptic.matrix() = Eigen::umeyama(tips_of(model, {}, clicks), rings, false);
  // The last joint turns the handle about its axis, which does not move the tip.
  if (gimbal == GimbalFit::Fitted)
    at.error.coefficients_rad.assign((model.joints.size() - model.gimbal - 1) * GimbalError::kTermsAJoint, 0.0);
  MatrixXd information;
  for (int step = 0; step < kSteps; ++step) {
    const MatrixXd jacobian = jacobian_of(model, clicks, at);
    information = jacobian.transpose() * jacobian;
    at = at.moved(-information.ldlt().solve(jacobian.transpose() * residuals_of(model, clicks, at)));
  }
  DeviceFit fit;
  fit.world_from_haptic.iso = at.world_from_haptic;
  fit.gimbal = at.error;
  fit.centre.m = at.centre_m;
  fit.covariance = information.inverse().topLeftCorner<6, 6>();
  add_distances(fit, (at.world_from_haptic * tips_of(model, at.error, clicks) - rings).colwise().norm().transpose());
  if (!(fit.rms_m <= kLargestClickRms_m)) {
    char text[120];
    std::snprintf(text, sizeof text, "the clicks miss their rings by %.1f mm rms, click %zu by %.1f mm",
                  fit.rms_m * 1e3, fit.worst + 1, fit.largest_m * 1e3);
    return clicks_refusal(text, "click that place again; if all miss, check that the device has not moved");
  }
  return fit;
}

double deviation_at_m(const DeviceFit& fit, const Point<World>& point) noexcept {
  const Vector3d arm = point.m - fit.centre.m;
  Eigen::Matrix<double, 3, 6> by;
  by.leftCols<3>() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;  // turn × arm
  by.rightCols<3>().setIdentity();
  return std::sqrt((by * fit.covariance * by.transpose()).trace() / 3.0);
}

std::string in_words(const DeviceFit& fit, std::span<const Click> clicks) {
  char text[240];
  std::snprintf(text, sizeof text,
                "%zu clicks miss their rings by %.2f ± %.2f mm (rms %.2f mm, largest %.2f mm: click %zu); the pose is "
                "known to %.2f mm rms at the middle of the rings",
                clicks.size(), fit.mean_m * 1e3, fit.deviation_m * 1e3, fit.rms_m * 1e3, fit.largest_m * 1e3,
                fit.worst + 1, std::sqrt(3.0) * deviation_at_m(fit, fit.centre) * 1e3);
  return text;
}

}  // namespace telepalp::mixed
