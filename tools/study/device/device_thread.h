#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "haptic_station/control/safety/force_limiter.h"
#include "haptic_station/loop/device_gate.h"
#include "haptic_station/ports/device.h"
#include "haptic_station/station/threads/tick_timer.h"
#include "proto/words/result.h"

namespace telepalp::study {

/// What a hand at a haptic device moves and feels. All but the destructor is called on the device's thread; nothing
/// allocates, locks, waits or throws.
class DeviceTask {
 public:
  virtual ~DeviceTask() = default;
  /// One tick of kTick_s: the hand is at `gated`. `reading`: what the device said. Returns the force on the hand,
  /// before the limiter.
  [[nodiscard]] virtual Force<HapticBase> feel(const loop::GatedReading& gated,
                                               const ports::DeviceReading& reading) noexcept = 0;
  /// The force that the limiter let through in this tick.
  virtual void given(const Force<HapticBase>& /*force*/) noexcept {}
  /// `seconds` passed without a tick.
  virtual void held_up(double /*seconds*/) noexcept {}
};

/// A haptic device, and the thread that drives it at 2 kHz with one task after the other. The force passes the limiter,
/// and falls to zero between tasks.
class DeviceThread {
 public:
  /// Starts the thread. `device` has answered.
  explicit DeviceThread(std::unique_ptr<ports::Device> device);
  ~DeviceThread();
  DeviceThread(const DeviceThread&) = delete;
  DeviceThread& operator=(const DeviceThread&) = delete;

  /// The thread works on `task` from its next tick on, and no longer on the one before; nullptr: on none. Returns when
  /// the tick in which it still did is over. Owner: the network thread.
  void work_on(DeviceTask* task) noexcept;
  /// The task that work_on() named last.
  [[nodiscard]] const DeviceTask* task() const noexcept { return asked_.load(std::memory_order_relaxed); }

 private:
  void run() noexcept;
  void tick(const station::TickTimer::Tick& due) noexcept;

  std::unique_ptr<ports::Device> device_;     // owner: the thread
  loop::DeviceGate gate_;                     // owner: the thread
  control::ForceLimiter limiter_;             // owner: the thread
  Force<HapticBase> fading_;                  // owner: the thread; force after a task
  std::atomic<DeviceTask*> asked_{nullptr};   // written by: network thread
  std::atomic<DeviceTask*> worked_{nullptr};  // written by: the thread, at the end of each tick
  std::atomic<bool> running_{true};
  std::thread thread_;
};

/// Connects to a device that `--device` names as telepalp-station does. Error: no device of this name, or no answer.
[[nodiscard]] Result<std::unique_ptr<DeviceThread>> connect_device_thread(const std::string& device);

}  // namespace telepalp::study
