#pragma once

#include "haptic_station/device/simulated_pair.h"
#include "haptic_station/ports/device.h"

namespace telepalp::device {

/// A simulated device under a real, tracked hand. The simulated hand is pulled towards the tracked position and pushes
/// the simulated end-effector. No person feels the force; everything else behaves as with a real device.
class HandDrivenDevice final : public ports::Device {
 public:
  HandDrivenDevice(const SimulatedDeviceSettings& device, const SimulatedHandSettings& hand,
                   const Point<HapticBase>& rest) noexcept
      : pair_(device, hand) {
    pair_.place(rest, rest);
    intention_.at = rest;
  }

  [[nodiscard]] ports::DeviceReading read() noexcept override {
    return {.at = pair_.device(), .velocity = pair_.device_velocity(), .age_s = 0.0};
  }
  void apply(const Wrench<HapticBase>& wrench, const ports::SurfaceContact&, double dt_s) noexcept override {
    last_force_ = wrench.force;
    pair_.step(wrench.force, intention_, dt_s);
  }
  void catch_up(double missed_s) noexcept override { pair_.step(last_force_, intention_, missed_s); }
  void hand_seen(const Point<HapticBase>& hand) noexcept override { intention_.at = hand; }

 private:
  SimulatedPair pair_;
  Intention intention_;
  Force<HapticBase> last_force_;
};

}  // namespace telepalp::device
