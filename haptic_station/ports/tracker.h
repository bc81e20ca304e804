#pragma once

#include <optional>

#include "haptic_station/ports/readings.h"

namespace telepalp::ports {

/// A hand tracker of any maker. Called on the haptic thread; does not allocate, lock, wait or throw.
class Tracker {
 public:
  virtual ~Tracker() = default;
  /// The newest sample. Each sample is returned once; nullopt means that there is no newer one. `device`: the device's
  /// reading at `now`, which gives the position of a simulated hand that holds the end-effector.
  [[nodiscard]] virtual std::optional<HandSample> sample(SessionTime now, const DeviceReading& device) noexcept = 0;
};

}  // namespace telepalp::ports
