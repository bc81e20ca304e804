#include "clients/mixed/anchor/headset_anchor.h"

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <set>

namespace telepalp::mixed {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kLeastTouchSpread_m = 0.01;
constexpr double kLargestRms_m = 0.015;
constexpr double kLeastTurn_rad = 0.2;

Error touches_refusal(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "touches", .fix = std::move(fix)};
}

/// The rotation about y that best turns the centred points `from` onto `to`: Kabsch in the horizontal plane.
Matrix3d heading(const Matrix3Xd& from, const Matrix3Xd& to) {
  double along = 0.0, across = 0.0;
  for (Eigen::Index i = 0; i < from.cols(); ++i) {
    along += from(0, i) * to(0, i) + from(2, i) * to(2, i);
    across += from(2, i) * to(0, i) - from(0, i) * to(2, i);
  }
  return Eigen::AngleAxisd(std::atan2(across, along), Vector3d::UnitY()).toRotationMatrix();
}

Result<void> check(std::span<const Touch> touches, const Matrix3Xd& centred) {
  std::set<int> places;
  for (const Touch& touch : touches) {
    if (!touch.known.m.allFinite() || !touch.touched.m.allFinite())
      return touches_refusal("a coordinate of a touch is not finite", "touch that place again, with the hand in view");
    places.insert(touch.place);
  }
  if (places.size() < 3)
    return touches_refusal("only " + std::to_string(places.size()) + " places were touched; an anchor needs three",
                           "touch three places or more, at least 20 cm from each other");
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(
      centred * centred.transpose() / static_cast<double>(centred.cols()), Eigen::EigenvaluesOnly);
  if (std::sqrt(std::max(solver.eigenvalues()[1], 0.0)) < kLeastTouchSpread_m)
    return touches_refusal("the places lie on a line or at one point", "touch a place beside the line");
  return {};
}

}  // namespace

Result<HeadsetAnchor> anchor_headset(std::span<const Touch> touches, Gravity gravity) {
  const auto count = static_cast<Eigen::Index>(touches.size());
  Matrix3Xd known(3, count), touched(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    known.col(i) = touches[static_cast<std::size_t>(i)].known.m;
    touched.col(i) = touches[static_cast<std::size_t>(i)].touched.m;
  }
  if (count == 0) return check(touches, Matrix3Xd::Zero(3, 1)).error();
  const Vector3d from_mean = known.rowwise().mean(), to_mean = touched.rowwise().mean();
  const Matrix3Xd from = known.colwise() - from_mean, to = touched.colwise() - to_mean;
  if (const Result<void> usable = check(touches, from); !usable) return usable.error();
  HeadsetAnchor anchor;
  Eigen::Isometry3d& iso = anchor.headset_from_haptic.iso;
  if (gravity == Gravity::Known)
    iso.linear() = heading(from, to);
  else
    iso.linear() = Eigen::umeyama(from, to, false).topLeftCorner<3, 3>();
  iso.translation() = to_mean - iso.linear() * from_mean;
  anchor.rms_m = std::sqrt((iso * known - touched).squaredNorm() / static_cast<double>(count));
  if (!(anchor.rms_m <= kLargestRms_m)) {
    char text[80];
    std::snprintf(text, sizeof text, "the touches miss their places by %.0f mm rms", anchor.rms_m * 1e3);
    return touches_refusal(text, "touch the places in the order that is shown");
  }
  return anchor;
}

/// The tip rests at one point p of the headset's frame, so p = R_i tip + t_i for each pose i. As a linear system,
/// solved by least squares: [R_i  -I] (tip, p) = -t_i.
Result<Vector3d> pivot_tip(std::span<const Eigen::Isometry3d> headset_from_tool) {
  const auto count = static_cast<Eigen::Index>(headset_from_tool.size());
  double turn_rad = 0.0;
  Eigen::MatrixXd system(3 * count, 6);
  Eigen::VectorXd right(3 * count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Isometry3d& pose = headset_from_tool[static_cast<std::size_t>(i)];
    system.block<3, 3>(3 * i, 0) = pose.linear();
    system.block<3, 3>(3 * i, 3) = -Matrix3d::Identity();
    right.segment<3>(3 * i) = -pose.translation();
    turn_rad = std::max(
        turn_rad, std::abs(Eigen::AngleAxisd(headset_from_tool.front().linear().transpose() * pose.linear()).angle()));
  }
  if (count < 4 || turn_rad < kLeastTurn_rad)
    return touches_refusal("the tool was turned too little about its tip",
                           "rest the tip at one point, and turn the tool widely");
  return Vector3d(system.colPivHouseholderQr().solve(right).head<3>());
}

}  // namespace telepalp::mixed
