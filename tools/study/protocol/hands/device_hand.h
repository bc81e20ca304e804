#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "haptic_station/control/safety/force_limiter.h"
#include "haptic_station/ports/device.h"
#include "haptic_station/station/threads/tick_timer.h"
#include "proto/words/latest_value.h"
#include "proto/words/spsc_ring.h"
#include "tools/study/protocol/hands/device_penetration.h"

namespace telepalp::study {

/// The haptic device of a participant, and the thread that drives it at 2 kHz with one penetration after the other. The
/// force passes the limiter, and falls to zero between penetrations.
class DeviceHand {
 public:
  /// Starts the thread. `device` has answered.
  explicit DeviceHand(std::unique_ptr<ports::Device> device);
  ~DeviceHand();
  DeviceHand(const DeviceHand&) = delete;
  DeviceHand& operator=(const DeviceHand&) = delete;

  /// A penetration that this device's hand moves. Only one at a time, which must end before this object.
  [[nodiscard]] std::unique_ptr<PersonTrial> begin(Prepared prepared, Condition condition);

 private:
  class Trial;
  void run() noexcept;
  void tick(const station::TickTimer::Tick& due) noexcept;
  /// The thread works on `penetration` from its next tick on; nullptr: on none. Returns when that tick is over.
  void work_on(DevicePenetration* penetration) noexcept;

  std::unique_ptr<ports::Device> device_;            // owner: the thread
  loop::DeviceGate gate_;                            // owner: the thread
  control::ForceLimiter limiter_;                    // owner: the thread
  Force<HapticBase> fading_;                         // owner: the thread; force after a penetration
  int until_view_ = 0;                               // owner: the thread
  std::atomic<DevicePenetration*> asked_{nullptr};   // written by: network thread
  std::atomic<DevicePenetration*> worked_{nullptr};  // written by: the thread, at the end of each tick
  LatestValue<TrialView> views_;                     // thread to network thread
  SpscRing<loop::TickSample, 4096> ticks_;           // thread to network thread; 2 s
  std::atomic<std::uint8_t> lost_{0};                // DevicePenetration::Lost
  std::atomic<bool> running_{true};
  std::thread thread_;
};

/// Connects to a device that `--device` names as telepalp-station does. Error: no device of this name, or no answer.
[[nodiscard]] Result<std::unique_ptr<DeviceHand>> connect_hand(const std::string& device);

}  // namespace telepalp::study
