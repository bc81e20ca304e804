#pragma once

#include <memory>
#include <utility>

#include "haptic_station/device/device.h"
#include "haptic_station/tracking/tracker.h"

namespace telepalp::device {

/// Any device with any tracker. The ages of both go to the watchdog as they are: a device that stops answering ages, a
/// tracker that stops gives no more samples.
class JoinedRig final : public station::Rig {
 public:
  JoinedRig(std::unique_ptr<Device> device, std::unique_ptr<tracking::Tracker> tracker) noexcept
      : device_(std::move(device)), tracker_(std::move(tracker)) {}

  [[nodiscard]] station::DeviceReading read() noexcept override { return device_->read(); }

  [[nodiscard]] std::optional<station::HandSample> hand(SessionTime now) noexcept override {
    const std::optional<station::HandSample> sample = tracker_->sample(now, device_->read());
    if (sample) device_->hand_seen(sample->hand);
    return sample;
  }

  void apply(const Force<HapticBase>& force, const effects::SurfaceContact& contact, double dt_s) noexcept override {
    device_->apply(force, contact, dt_s);
  }

 private:
  std::unique_ptr<Device> device_;
  std::unique_ptr<tracking::Tracker> tracker_;
};

}  // namespace telepalp::device
