#pragma once

#include <optional>

#include "haptic_station/effects/surface_contact.h"
#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::station {

/// What the haptic device says at a tick.
struct DeviceReading {
  Point<HapticBase> at;
  Vector<HapticBase> velocity;  ///< [m/s]
  double age_s = 0.0;           ///< since the device last answered
};

/// One sample of the hand tracker, at the tracker's own time.
struct HandSample {
  SessionTime at;
  Point<HapticBase> hand;
};

/// What the doctor's hand meets: a haptic device and a hand tracker. Every method is called on the haptic thread and
/// neither allocates, locks nor throws; the only system calls are the device's own.
class Rig {
 public:
  virtual ~Rig() = default;
  [[nodiscard]] virtual DeviceReading read() noexcept = 0;
  /// The newest sample of the hand that has not been given yet.
  [[nodiscard]] virtual std::optional<HandSample> hand(SessionTime now) noexcept = 0;
  /// The force to hold for the next `dt_s`. `contact` is what the surface said of the reading, for rigs that simulate.
  virtual void apply(const Force<HapticBase>& force, const effects::SurfaceContact& contact, double dt_s) noexcept = 0;
};

}  // namespace telepalp::station
