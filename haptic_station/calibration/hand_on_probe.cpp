#include "haptic_station/calibration/hand_on_probe.h"

#include <Eigen/Dense>
#include <string>

#include "proto/words/counted.h"

namespace telepalp::calibration {
namespace {

constexpr double kFurthest_rad = 0.2618;  // largest angle that a pose may have: 15 degrees

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Error probe_refusal(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "calibration by hand on probe", .fix = std::move(fix)};
}

constexpr const char* kFixMeasured =
    "give positions in metres; leave out poses in which the tracker did not see the hand, or the device gave no "
    "position";

/// The error of a pose that is no rigid motion or lies beyond 10 m; nullopt for a valid pose. `fix_position`: the fix
/// for a bad position.
std::optional<Error> refuse_pose(const Isometry3d& pose, const std::string& name, const char* fix_position) {
  constexpr double kRotationError = 1e-3;
  if (!pose.matrix().allFinite() || pose.translation().cwiseAbs().maxCoeff() > 10.0)
    return probe_refusal(name + " is not finite, or has a coordinate beyond 10 m", fix_position);
  const Matrix3d r = pose.linear();
  if ((r * r.transpose() - Matrix3d::Identity()).cwiseAbs().maxCoeff() > kRotationError)
    return probe_refusal(name + " has no valid rotation: its axes are not perpendicular, or not of length one",
                         "give a rotation matrix");
  if (r.determinant() < 0.0)
    return probe_refusal(name + " is mirrored (determinant -1)",
                         "check the sign of each axis: frames are right-handed");
  return std::nullopt;
}

/// Chordal mean of the rotations whose sum is `sum`; nullopt when they cancel.
std::optional<Matrix3d> mean_rotation(const Matrix3d& sum) {
  const Eigen::JacobiSVD<Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (svd.singularValues()[1] < 0.1 * svd.singularValues()[0]) return std::nullopt;  // the rotations cancel
  const Matrix3d& u = svd.matrixU();
  const Matrix3d& v = svd.matrixV();
  const double sign = (u * v.transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return u * Vector3d(1.0, 1.0, sign).asDiagonal() * v.transpose();
}

}  // namespace

Result<ProbeCalibration> calibrate_hand_on_probe(std::span<const HandOnProbe> poses, const Isometry3d& probe_from_hand,
                                                 const ProbeSettings& settings) {
  if (poses.empty())
    return probe_refusal("no pose is given", "lay the hand on the probe, and measure at least one pose");
  if (const auto error = refuse_pose(probe_from_hand, "the pose of the hand on the probe (--hand-at)",
                                     "give x, y and z of --hand-at in metres"))
    return *error;
  const double n = static_cast<double>(poses.size());
  Matrix3d sum = Matrix3d::Zero();
  Vector3d to_mean = Vector3d::Zero();
  Vector3d from_mean = Vector3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::string name = "pose " + std::to_string(i + 1);
    if (const auto error = refuse_pose(poses[i].tracker_from_hand, name + " of the hand", kFixMeasured)) return *error;
    if (const auto error = refuse_pose(poses[i].haptic_from_probe, name + " of the probe", kFixMeasured)) return *error;
    const Isometry3d haptic_from_hand = poses[i].haptic_from_probe * probe_from_hand;
    sum += haptic_from_hand.linear() * poses[i].tracker_from_hand.linear().transpose();
    to_mean += haptic_from_hand.translation() / n;
    from_mean += poses[i].tracker_from_hand.translation() / n;
  }
  const std::optional<Matrix3d> rotation = mean_rotation(sum);
  if (!rotation)
    return probe_refusal("the poses turn the hand in opposite directions on the probe, so their rotations have no mean",
                         "align the hand with the probe, the same way each time");
  ProbeCalibration fit;
  fit.haptic_from_tracker.linear() = *rotation;
  fit.haptic_from_tracker.translation() = to_mean - *rotation * from_mean;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Isometry3d predicted = poses[i].haptic_from_probe * probe_from_hand;
    const Isometry3d fitted = fit.haptic_from_tracker * poses[i].tracker_from_hand;
    fit.residuals.each_m.push_back((predicted.translation() - fitted.translation()).norm());
    fit.angles_rad.push_back(Eigen::AngleAxisd(predicted.linear() * fitted.linear().transpose()).angle());
    if (fit.residuals.each_m.back() > settings.furthest_m || fit.angles_rad.back() > kFurthest_rad)
      return probe_refusal(
          "pose " + std::to_string(i + 1) + " disagrees with the others by " +
              std::to_string(std::lround(fit.residuals.each_m.back() * 1e3)) + " mm and " +
              counted(static_cast<std::uint64_t>(std::lround(fit.angles_rad.back() * 57.29578)), "degree", "degrees"),
          "lay the hand on the probe the same way each time, and measure this pose again");
  }
  return fit;
}

}  // namespace telepalp::calibration
