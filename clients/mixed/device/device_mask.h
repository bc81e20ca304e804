#pragma once

#include <utility>
#include <vector>

#include "clients/mixed/device/device_model.h"
#include "clients/mixed/view/mask.h"
#include "clients/mixed/view/view.h"

namespace telepalp::mixed {

/// How much larger than the device its mask is.
struct MaskMargin {
  double share = 0.0;    ///< sides and radii are longer by this share. Paper S3: 0.05
  double least_m = 0.0;  ///< margin at `centre`
  double per_m = 0.0;    ///< margin per metre of distance from `centre`, which a rotation's error causes
  Point<HapticBase> centre;

  /// The margin at a point in the haptic base's frame [m]: root of the sum of squares of least_m and per_m's part.
  [[nodiscard]] double at_m(const Eigen::Vector3d& haptic_m) const noexcept;
};

/// The margin of paper S3 (docs/sources.md) 5.1: sides and radii are 5 percent longer.
[[nodiscard]] MaskMargin paper_margin() noexcept;

/// Three standard deviations of the calibration's error. `deviation_m`: one standard deviation of a point at `centre`,
/// on each axis. `turn_rad`: one standard deviation of the rotation about each axis. A point at distance r from the
/// centre is off by deviation_m and by turn_rad * r; the two errors are independent.
[[nodiscard]] MaskMargin calibrated_margin(double deviation_m, double turn_rad,
                                           const Point<HapticBase>& centre) noexcept;

/// A device with its place in the world and the angles of its joints.
struct StandingDevice {
  DeviceModel model;
  std::vector<double> joints_rad;
  Transform<World, HapticBase> world_from_haptic;

  /// The two ends of the handle: first the end with the tip.
  [[nodiscard]] std::pair<Point<World>, Point<World>> handle() const;
};

/// The pixels that the device covers, enlarged by the margin: each link is a prism, the handle a truncated cone. A body
/// that comes nearer to the camera than kNearest_m is cut at that distance.
[[nodiscard]] Mask device_mask(const StandingDevice& device, const View& view, const MaskMargin& margin);

/// The pixels of a cone between two points of the world, such as a virtual tool with the handle's form.
[[nodiscard]] Mask cone_mask(const View& view, const Point<World>& from, const Point<World>& to, double from_radius_m,
                             double to_radius_m);

}  // namespace telepalp::mixed
