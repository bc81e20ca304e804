#pragma once

#include <memory>
#include <utility>

#include "haptic_station/ports/device.h"
#include "haptic_station/ports/tracker.h"

namespace telepalp::device {

/// Combines any device with any tracker. The station's watchdog detects a silent part: the reading of a silent device
/// grows old, and a silent tracker gives no samples.
class JoinedRig final : public ports::Rig {
 public:
  JoinedRig(std::unique_ptr<ports::Device> device, std::unique_ptr<ports::Tracker> tracker) noexcept
      : device_(std::move(device)), tracker_(std::move(tracker)) {}

  [[nodiscard]] ports::DeviceReading read() noexcept override { return device_->read(); }

  [[nodiscard]] std::optional<ports::HandSample> hand(SessionTime now) noexcept override {
    const std::optional<ports::HandSample> sample = tracker_->sample(now, device_->read());
    if (sample) device_->hand_seen(sample->hand);
    return sample;
  }

  void catch_up(double missed_s) noexcept override { device_->catch_up(missed_s); }

  void apply(const Wrench<HapticBase>& wrench, const ports::SurfaceContact& contact, double dt_s) noexcept override {
    device_->apply(wrench, contact, dt_s);
  }

 private:
  std::unique_ptr<ports::Device> device_;
  std::unique_ptr<ports::Tracker> tracker_;
};

}  // namespace telepalp::device
