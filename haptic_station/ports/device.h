#pragma once

#include "haptic_station/ports/readings.h"
#include "haptic_station/ports/surface_contact.h"

namespace telepalp::ports {

/// A haptic device of any maker. Every method is called on the haptic thread; none allocates, locks, waits or throws.
class Device {
 public:
  virtual ~Device() = default;
  /// The end-effector's position, in the device's own frame, and what else the device measures and can give. The
  /// reading's age is infinite until the device has answered once.
  [[nodiscard]] virtual DeviceReading read() noexcept = 0;
  /// Applies `wrench` for the next `dt_s`; its torque is zero unless the last reading stated that the device gives
  /// torques. `contact`: the contact at the last read(); only a device with a controller of its own uses it.
  virtual void apply(const Wrench<HapticBase>& wrench, const SurfaceContact& contact, double dt_s) noexcept = 0;
  /// As Rig::catch_up().
  virtual void catch_up(double /*missed_s*/) noexcept {}
  /// Gets the hand's position that the tracker sees. A simulated device follows it, as if the hand held the device.
  virtual void hand_seen(const Point<HapticBase>&) noexcept {}
};

}  // namespace telepalp::ports
