#include "haptic_station/calibration/offset_procedure.h"

#include <string>

namespace telepalp::calibration {
namespace {

constexpr double kMostMoved_m = 0.005;  // largest residual; beyond it the hand moved on the end-effector

using Eigen::Vector3d;

constexpr double kFurthestHand_m = 10.0;

Error offset_refusal(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "calibration by offset", .fix = std::move(fix)};
}

bool usable(const Vector3d& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() <= kFurthestHand_m; }

}  // namespace

Result<OffsetCalibration> calibrate_offset(std::span<const Touch> touches, const OffsetSettings& settings) {
  if (touches.empty() || touches.size() < settings.least_touches)
    return offset_refusal(
        "too few pairs of positions of hand and end-effector were measured: " + std::to_string(touches.size()) +
            " instead of at least " + std::to_string(settings.least_touches),
        "keep the hand on the end-effector, in the tracker's view, until the measurement ends; or, if --pairs is "
        "given, add rows to its file");
  Vector3d hand = Vector3d::Zero();
  Vector3d end_effector = Vector3d::Zero();
  for (const Touch& touch : touches) {
    if (!usable(touch.hand.m) || !usable(touch.end_effector.m))
      return offset_refusal(
          "a position of hand or end-effector is not finite, or has a coordinate beyond 10 m",
          "give positions in metres; leave out measurements in which the tracker did not see the hand, or "
          "the device gave no position");
    hand += touch.hand.m / static_cast<double>(touches.size());
    end_effector += touch.end_effector.m / static_cast<double>(touches.size());
  }
  OffsetCalibration fit;
  fit.haptic_from_tracker.iso.linear() = Vector3d(1.0, -1.0, -1.0).asDiagonal();  // S1 eq. (4)
  fit.haptic_from_tracker.iso.translation() = end_effector - fit.haptic_from_tracker.iso.linear() * hand;
  for (const Touch& touch : touches)
    fit.residuals.each_m.push_back((fit.haptic_from_tracker * touch.hand - touch.end_effector).v.norm());
  if (fit.residuals.largest_m() > kMostMoved_m)
    return offset_refusal("the hand moved on the end-effector by up to " +
                              std::to_string(std::lround(fit.residuals.largest_m() * 1e3)) + " mm",
                          "keep the hand still on the end-effector, in the tracker's view, and measure again");
  return fit;
}

}  // namespace telepalp::calibration
