#pragma once

#include <chrono>

#include "haptic_station/ports/tracker.h"

namespace telepalp::tracking {

/// Stands in for a tracker when the person grips the end-effector: the hand's position is the device's position,
/// sampled 100 times a second. A device that has been silent for 50 ms gives no samples.
class GripTracker final : public ports::Tracker {
 public:
  [[nodiscard]] std::optional<ports::HandSample> sample(SessionTime now,
                                                        const ports::DeviceReading& device) noexcept override {
    constexpr double kSilent_s = 0.05;
    if (now < next_ || !(device.age_s < kSilent_s)) return std::nullopt;
    next_ = now + std::chrono::milliseconds(10);
    return ports::HandSample{now - from_seconds(device.age_s), device.at, std::nullopt};
  }

 private:
  SessionTime next_{};
};

}  // namespace telepalp::tracking
