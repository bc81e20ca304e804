#pragma once

#include <memory>
#include <optional>

#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/loop/tick.h"

namespace telepalp::trials {

inline constexpr double kFrame_hz = 30.0;  ///< of the camera

/// The camera of every trial: straight above the skin's middle, which is H's origin; H's y axis points towards the
/// camera.
[[nodiscard]] Transform<HapticBase, DepthCamera> trial_camera(double height_m = 0.8) noexcept;

/// A simulated patient: snapshots of the skin at 30 Hz, as the haptic loop gets them, and the true skin beside them.
class TrialSkin {
 public:
  virtual ~TrialSkin() = default;
  /// The new surface if a camera has made one by `time_s`, else nullptr. Valid until the next surface. Call it at each
  /// tick. `device`: centre of the region that the hand can reach; the surface need cover only this region.
  [[nodiscard]] virtual const loop::TouchableSurface* newer(double time_s, const Point<HapticBase>& device) = 0;
  /// Depth of `point` below the true skin [m]; negative outside.
  [[nodiscard]] virtual double true_depth_m(const Point<HapticBase>& point, double time_s) const = 0;
};

/// A level skin that rises and falls as a sine. The snapshots and their predictions are exact, so that a trial tests
/// the controller alone. `begins_s`: time of the sine at the trial's start [s].
[[nodiscard]] std::unique_ptr<TrialSkin> level_skin(const device::BreathingPlane& plane, double begins_s = 0.0);

/// A barrel-shaped belly under a Kinect-like camera with noise and disparity steps. The station's surface
/// stage makes the surface from the camera's images.
struct BellySettings {
  double breathing_m = 0.0;  ///< amplitude of the belly's rise and fall, a sine
  double rate_hz = 0.25;
  double begins_s = 0.0;  ///< time of the sine at the trial's start
  std::uint64_t seed = 1;
};
[[nodiscard]] std::unique_ptr<TrialSkin> camera_skin(const BellySettings& belly);

}  // namespace telepalp::trials
