#include "haptic_station/station/threads/haptic_thread.h"

#include <algorithm>
#include <future>
#include <optional>

#include "haptic_station/loop/rig_tick.h"
#include "haptic_station/station/threads/journal_thread.h"
#include "haptic_station/station/threads/tick_timer.h"

namespace telepalp::station {
namespace {

using Clock = TickTimer::Clock;

constexpr double kTick_s = std::chrono::duration<double>(loop::kTickPeriod).count();
constexpr std::uint64_t kTicksPerBill = 2000;
constexpr std::uint64_t kTicksPerCompensation = 20;  // 100 Hz
constexpr int kTicksOfGreeting = 2000;
constexpr double kGreeted_s = 0.02;  // a device that answered this recently will also answer at the first tick

}  // namespace

Result<RealtimeGrant> HapticThread::start(Realtime realtime) {
  std::promise<Result<RealtimeGrant>> entered;
  std::future<Result<RealtimeGrant>> granted = entered.get_future();
  running_ = true;
  thread_ = std::thread([this, realtime, entered = std::move(entered)]() mutable {
    Result<RealtimeGrant> result = enter_realtime(realtime);
    const bool go = result.ok();
    entered.set_value(std::move(result));
    if (go) run();
  });
  Result<RealtimeGrant> result = granted.get();
  if (!result) stop();
  return result;
}

void HapticThread::stop() {
  running_ = false;
  if (thread_.joinable()) thread_.join();
}

/// Commands the device before the first tick. A device that only answers commands has been silent while the station
/// waited for a surface, and this must not be a fault.
void HapticThread::greet_device(TickTimer& timer) noexcept {
  for (int ticks = 0; ticks < kTicksOfGreeting && running_.load(std::memory_order_relaxed); ++ticks) {
    if (rig_.read().age_s <= kGreeted_s) return;
    rig_.apply({}, {}, kTick_s);
    (void)timer.wait();
  }
}

void HapticThread::run() noexcept {
  TickTimer timer(Clock::now() + loop::kTickPeriod, loop::kTickPeriod);
  greet_device(timer);
  while (running_.load(std::memory_order_relaxed)) {
    const TickTimer::Tick due = timer.wait();
    if (due.missed > 0) counts_.deadlines_missed.fetch_add(due.missed, std::memory_order_relaxed);
    tick(due);
  }
}

bool HapticThread::asked_to_rearm() noexcept {
  return rearm_.load(std::memory_order_relaxed) && rearm_.exchange(false, std::memory_order_relaxed);
}

void HapticThread::tick(const TickTimer::Tick& due) noexcept {
  const Clock::time_point began = Clock::now();
  const SessionTime now{due.deadline.time_since_epoch() +
                        Nanoseconds{clock_offset_ns_.load(std::memory_order_relaxed)}};
  loop::TickIn given = loop::due_at(now, due.missed);
  given.surface = surfaces_.take() ? &surfaces_.current() : nullptr;
  given.rearm = asked_to_rearm();
  Clock::time_point decided;
  std::optional<core::JournalTick> kept;
  if (journal_ != nullptr) kept.emplace().tick = tick_;
  loop::TickOut out = loop::tick_at_rig(
      loop_, rig_, given,
      [&](const loop::TickIn& in) {
        if (kept) keep(in, *kept);
        const Point<HapticBase> at = loop_.in_patient_frame(in.reading.at);
        if (!at.m.allFinite()) return;  // the stages keep the last position, as the device gate does
        device_.put(at);
        device_to_surface_.put(at);
        for (LatestValue<core::ToolAt>* stage : stages_) stage->put({at, in.reading.attitude});
      },
      [&decided](const loop::TickIn&, const loop::TickOut&) { decided = Clock::now(); });
  if (kept) {
    keep(out, *kept);
    journal_->add(*kept);
  }
  out.sample.stamp_ns = to_nanoseconds(now);
  out.sample.late_ns = static_cast<std::uint32_t>(due.late.count());
  out.sample.work_us = std::chrono::duration<float, std::micro>(decided - began).count();
  hand_over(out.sample);
}

/// Numbers the tick, and hands it and what is due with it to the network thread.
void HapticThread::hand_over(loop::TickSample& sample) noexcept {
  sample.tick = tick_++;
  if (tick_ % kTicksPerCompensation == 0) {
    loop::Compensation compensation = loop_.compensation();
    compensation.stamp_ns = sample.stamp_ns;
    compensation_.put(compensation);
  }
  if (tick_ % kTicksPerBill == 0) bill_.put(bill_of(loop_.controller().effects()));
  if (!ticks_.try_push(sample)) counts_.ticks_dropped.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace telepalp::station
