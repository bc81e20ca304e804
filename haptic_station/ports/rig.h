#pragma once

#include <optional>

#include "haptic_station/ports/readings.h"
#include "haptic_station/ports/surface_contact.h"

namespace telepalp::ports {

/// The equipment at the doctor's hand: a haptic device and a hand tracker. Every method is called on the haptic thread
/// and neither allocates, locks nor throws; the only system calls are the device's own.
class Rig {
 public:
  virtual ~Rig() = default;
  [[nodiscard]] virtual DeviceReading read() noexcept = 0;
  /// The newest sample of the hand. Each sample is returned once; nullopt means that there is no newer one.
  [[nodiscard]] virtual std::optional<HandSample> hand(SessionTime now) noexcept = 0;
  /// Tells that ticks were missed for `missed_s`, in which the last wrench stayed applied. A real device has moved
  /// meanwhile; a simulated one moves now, so that its next reading is not a jump.
  virtual void catch_up(double /*missed_s*/) noexcept {}
  /// Applies `wrench` for the next `dt_s`. `contact`: the contact at the last read(), which only a simulated hand (to
  /// find the skin's height) and a device with a controller of its own use.
  virtual void apply(const Wrench<HapticBase>& wrench, const SurfaceContact& contact, double dt_s) noexcept = 0;
};

}  // namespace telepalp::ports
