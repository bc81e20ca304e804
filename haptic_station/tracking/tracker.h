#pragma once

#include <optional>

#include "haptic_station/loop/rig.h"
#include "proto/words/time.h"

namespace telepalp::tracking {

/// A hand tracker, whichever its maker. Called on the haptic thread; neither allocates, locks, waits nor throws.
class Tracker {
 public:
  virtual ~Tracker() = default;
  /// The newest sample that has not been given yet, at the tracker's own time. `device`: what the device says now, for
  /// trackers that are none: a hand that holds the end-effector is where it is.
  [[nodiscard]] virtual std::optional<station::HandSample> sample(SessionTime now,
                                                                  const station::DeviceReading& device) noexcept = 0;
};

}  // namespace telepalp::tracking
