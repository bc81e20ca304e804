#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "haptic_station/core/effect_stage.h"
#include "haptic_station/core/outbox/outbox.h"
#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/ports/rig.h"
#include "haptic_station/station/threads/bill.h"
#include "haptic_station/station/threads/realtime.h"
#include "haptic_station/station/threads/tick_timer.h"
#include "proto/words/latest_value.h"
#include "proto/words/spsc_ring.h"

namespace telepalp::station {

class JournalThread;

/// Ring of ticks from the haptic thread to the network thread; it holds 2 s.
using TickRing = SpscRing<loop::TickSample, 4096>;

/// Counters that the haptic thread writes and other threads read.
struct HapticCounts {
  std::atomic<std::uint64_t> deadlines_missed{0};
  std::atomic<std::uint64_t> ticks_dropped{0};  ///< ticks dropped because the ring was full
};

/// These counters, and the number of depth images that gave no surface, for the outbox.
[[nodiscard]] inline core::Outbox::Counts counts_of(const HapticCounts& counts, std::uint64_t frames_dropped) noexcept {
  return {.deadlines_missed = counts.deadlines_missed.load(std::memory_order_relaxed),
          .ticks_dropped = counts.ticks_dropped.load(std::memory_order_relaxed),
          .frames_dropped = frames_dropped};
}

/// The 2 kHz thread: reads the rig, ticks the loop, applies the force. It does not allocate, and waits only for the
/// timer and the rig.
class HapticThread {
 public:
  /// `device_to_surface`: gets the device's position in H (HapticLoop::in_patient_frame()) at every tick.
  HapticThread(loop::HapticLoop& loop, ports::Rig& rig, LatestValue<loop::TouchableSurface>& surfaces, TickRing& ticks,
               LatestValue<Point<HapticBase>>& device_to_surface)
      : loop_(loop), rig_(rig), surfaces_(surfaces), ticks_(ticks), device_to_surface_(device_to_surface) {}
  /// Keeps each tick in `journal`, which must outlive this object. Call it before start().
  void write_to(JournalThread& journal) noexcept { journal_ = &journal; }
  /// Tells the slow stage of an effect at each tick where the tool is. Call it before start().
  void tell(LatestValue<core::ToolAt>& stage) { stages_.push_back(&stage); }
  ~HapticThread() { stop(); }
  HapticThread(const HapticThread&) = delete;
  HapticThread& operator=(const HapticThread&) = delete;

  /// Starts the thread and returns what the operating system granted it. Error: as for enter_realtime().
  [[nodiscard]] Result<RealtimeGrant> start(Realtime realtime);
  void stop();
  /// Runs one tick on the calling thread, in virtual time: its session time is `due.deadline` plus the clock offset.
  /// Call it only while the thread does not run.
  void tick(const TickTimer::Tick& due) noexcept;
  [[nodiscard]] const HapticCounts& counts() const noexcept { return counts_; }
  /// Passes an operator's request to re-arm to the next tick.
  void rearm() noexcept { rearm_.store(true, std::memory_order_relaxed); }
  /// Computing time of each effect, about once a second. Read by the network thread.
  [[nodiscard]] LatestValue<Bill>& bill() noexcept { return bill_; }
  /// The delay compensation, 100 times a second. Read by the network thread.
  [[nodiscard]] LatestValue<loop::Compensation>& compensation() noexcept { return compensation_; }
  /// The device's position in H (HapticLoop::in_patient_frame()), at every tick. Read by the collision thread, if any.
  [[nodiscard]] LatestValue<Point<HapticBase>>& device() noexcept { return device_; }

  /// Sets session time minus this machine's steady clock. The network thread updates it.
  void set_clock_offset(Nanoseconds offset) noexcept {
    clock_offset_ns_.store(offset.count(), std::memory_order_relaxed);
  }

 private:
  void run() noexcept;
  void greet_device(TickTimer& timer) noexcept;
  [[nodiscard]] bool asked_to_rearm() noexcept;
  void hand_over(loop::TickSample& sample) noexcept;

  loop::HapticLoop& loop_;                             // owner: haptic thread
  ports::Rig& rig_;                                    // owner: haptic thread
  LatestValue<loop::TouchableSurface>& surfaces_;      // written by: surface, collision or network thread
  TickRing& ticks_;                                    // read by: network thread
  LatestValue<Point<HapticBase>>& device_to_surface_;  // read by: surface thread
  HapticCounts counts_;
  LatestValue<Point<HapticBase>> device_;         // read by: collision thread
  LatestValue<loop::Compensation> compensation_;  // read by: network thread
  LatestValue<Bill> bill_;                        // read by: network thread
  std::atomic<std::int64_t> clock_offset_ns_{0};
  std::atomic<bool> running_{false};
  std::atomic<bool> rearm_{false};
  JournalThread* journal_ = nullptr;                // nullptr: no journal is written
  std::vector<LatestValue<core::ToolAt>*> stages_;  // read by: the threads of the effects' slow stages
  std::uint64_t tick_ = 0;
  std::thread thread_;
};

}  // namespace telepalp::station
