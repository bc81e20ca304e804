#pragma once

#include "haptic_station/ports/readings.h"
#include "haptic_station/ports/surface_contact.h"

namespace telepalp::ports {

/// A haptic device of any maker. Every method is called on the haptic thread; none allocates, locks, waits or throws.
class Device {
 public:
  virtual ~Device() = default;
  /// Where the end-effector is. The reading's age is infinite until the device has answered once.
  [[nodiscard]] virtual DeviceReading read() noexcept = 0;
  /// Shows `force` for the next `dt_s`. `contact`: the surface's answer for the last reading, for devices that draw it.
  virtual void apply(const Force<HapticBase>& force, const SurfaceContact& contact, double dt_s) noexcept = 0;
  /// Where the tracker sees the hand, for simulated devices: they are held at that place.
  virtual void hand_seen(const Point<HapticBase>&) noexcept {}
};

}  // namespace telepalp::ports
