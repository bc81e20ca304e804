#pragma once

#include <string>

#include "haptic_station/effects/surface_contact.h"
#include "haptic_station/loop/rig.h"
#include "proto/words/frames.h"

namespace telepalp::device {

/// A haptic device, whichever its maker. All methods are called on the haptic thread; none allocates, locks, waits or
/// throws.
class Device {
 public:
  virtual ~Device() = default;
  /// Where the end-effector is. Its age is infinite before the device has answered once.
  [[nodiscard]] virtual station::DeviceReading read() noexcept = 0;
  /// The force to show for the next `dt_s`, and what the surface says of the place, for devices that show it.
  virtual void apply(const Force<HapticBase>& force, const effects::SurfaceContact& contact, double dt_s) noexcept = 0;
  /// Where the tracker sees the hand, for devices that only simulate being held.
  virtual void hand_seen(const Point<HapticBase>&) noexcept {}
};

}  // namespace telepalp::device
