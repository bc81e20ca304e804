#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/ports/rig.h"
#include "haptic_station/station/threads/bill.h"
#include "haptic_station/station/threads/realtime.h"
#include "haptic_station/station/threads/tick_timer.h"
#include "proto/words/latest_value.h"
#include "proto/words/spsc_ring.h"

namespace telepalp::station {

/// Ticks wait here for the network thread: two seconds of them.
using TickRing = SpscRing<TickSample, 4096>;

inline constexpr std::chrono::microseconds kTickPeriod{500};  // 2 kHz, S1 II.D

/// What the haptic thread counts for others to read.
struct HapticCounts {
  std::atomic<std::uint64_t> deadlines_missed{0};
  std::atomic<std::uint64_t> ticks_untold{0};  ///< the ring was full
};

/// The 2 kHz thread: reads the rig, ticks the loop, applies the force. It allocates nothing and waits for nothing but
/// the timer and the rig.
class HapticThread {
 public:
  /// `device_to_surface`: gets the device's position at every tick, for the surface thread.
  HapticThread(HapticLoop& loop, ports::Rig& rig, LatestValue<TouchableSurface>& surfaces, TickRing& ticks,
               LatestValue<Point<HapticBase>>& device_to_surface)
      : loop_(loop), rig_(rig), surfaces_(surfaces), ticks_(ticks), device_to_surface_(device_to_surface) {}
  ~HapticThread() { stop(); }
  HapticThread(const HapticThread&) = delete;
  HapticThread& operator=(const HapticThread&) = delete;

  /// Returns when the thread ticks: true, with real-time priority; or why it must not.
  [[nodiscard]] Result<bool> start(Realtime realtime);
  void stop();
  [[nodiscard]] const HapticCounts& counts() const noexcept { return counts_; }
  /// An operator asks to re-arm; counts for the next tick.
  void rearm() noexcept { rearm_.store(true, std::memory_order_relaxed); }
  /// What the effects cost, about once a second. The network thread takes it.
  [[nodiscard]] LatestValue<Bill>& bill() noexcept { return bill_; }
  /// What is done about delay, 100 times a second. The network thread takes it.
  [[nodiscard]] LatestValue<Compensation>& compensation() noexcept { return compensation_; }
  /// Where the device is, at every tick. The collision thread takes it, where there is one.
  [[nodiscard]] LatestValue<Point<HapticBase>>& device() noexcept { return device_; }

  /// Session time less this machine's steady clock; the network thread keeps it up to date.
  void set_clock_offset(Nanoseconds offset) noexcept {
    clock_offset_ns_.store(offset.count(), std::memory_order_relaxed);
  }

 private:
  void run() noexcept;
  void greet_device(TickTimer& timer) noexcept;
  void tick(const TickTimer::Tick& due) noexcept;

  HapticLoop& loop_;                                   // owner: haptic thread
  ports::Rig& rig_;                                    // owner: haptic thread
  LatestValue<TouchableSurface>& surfaces_;            // written by: surface thread
  TickRing& ticks_;                                    // read by: network thread
  LatestValue<Point<HapticBase>>& device_to_surface_;  // read by: surface thread
  HapticCounts counts_;
  LatestValue<Point<HapticBase>> device_;   // read by: collision thread
  LatestValue<Compensation> compensation_;  // read by: network thread
  LatestValue<Bill> bill_;                  // read by: network thread
  std::atomic<std::int64_t> clock_offset_ns_{0};
  std::atomic<bool> running_{false};
  std::atomic<bool> rearm_{false};
  std::uint64_t tick_ = 0;
  std::thread thread_;
};

}  // namespace telepalp::station
