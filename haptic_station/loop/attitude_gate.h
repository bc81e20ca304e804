#pragma once

#include <cstdint>
#include <optional>

#include "haptic_station/ports/readings.h"

namespace telepalp::loop {

/// The attitude of a device's reading after the gate: a unit quaternion, or nullopt if the device measures none.
///
/// A quaternion that is not finite, or shorter than 0.1, counts as a glitch, and so does a turn that is faster than a
/// hand. A glitch is bridged: the last attitude holds, for up to 20 ms. After that, an attitude that is no rotation
/// counts as not measured, and one that agrees with the readings before it is taken as it is; the controller's
/// VirtualTool turns to it without loading the effects. Owner: haptic thread.
class AttitudeGate {
 public:
  [[nodiscard]] std::optional<Eigen::Quaterniond> step(const ports::DeviceReading& reading, double dt_s) noexcept;

  /// The angular velocity of the reading that step() accepted last; zero while a glitch is bridged, and where the
  /// reading is not finite [rad/s].
  [[nodiscard]] Vector<HapticBase> turning(const ports::DeviceReading& reading) const noexcept {
    return last_ && bridged_s_ <= 0.0 && reading.turning.v.allFinite() ? reading.turning : Vector<HapticBase>{};
  }
  /// Number of bridged glitches since start.
  [[nodiscard]] std::uint64_t jumps() const noexcept { return jumps_; }

 private:
  std::optional<Eigen::Quaterniond> last_;
  double bridged_s_ = 0.0;
  std::uint64_t jumps_ = 0;
};

}  // namespace telepalp::loop
