#include "haptic_station/station/threads/effect_stage_thread.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace telepalp::station {

using SteadyClock = std::chrono::steady_clock;

struct EffectStageThread::Shared {
  std::unique_ptr<core::EffectStage> stage;  // owner: the stage's thread
  std::function<SessionTime()> now;          // guarded by `mutex`; not called once `stopped`
  LatestValue<core::ToolAt> tool;            // haptic thread to the stage's thread
  std::mutex mutex;                          // of the flags; the haptic thread never takes it
  std::condition_variable changed;
  bool stopped = false;
  bool ended = false;  // the thread's last run is over

  /// nullopt: the stage is to end.
  [[nodiscard]] std::optional<SessionTime> time() {
    const std::lock_guard lock(mutex);
    return stopped ? std::nullopt : std::optional(now());
  }
  void wait_until(SteadyClock::time_point then) {
    std::unique_lock lock(mutex);
    changed.wait_until(lock, then, [this] { return stopped; });
  }
};

EffectStageThread::EffectStageThread(std::unique_ptr<core::EffectStage> stage, std::function<SessionTime()> now)
    : shared_(std::make_shared<Shared>()) {
  shared_->stage = std::move(stage);
  shared_->now = std::move(now);
  thread_ = std::thread([shared = shared_] { run(*shared); });
}

EffectStageThread::~EffectStageThread() {
  constexpr auto kPatience = std::chrono::milliseconds(200);
  std::unique_lock lock(shared_->mutex);
  shared_->stopped = true;
  shared_->changed.notify_all();
  const bool ended = shared_->changed.wait_for(lock, kPatience, [this] { return shared_->ended; });
  lock.unlock();
  if (ended)
    thread_.join();
  else
    thread_.detach();
}

LatestValue<core::ToolAt>& EffectStageThread::tool() noexcept { return shared_->tool; }

void EffectStageThread::run(Shared& shared) {
  constexpr auto kLook = std::chrono::milliseconds(1);  // for the first position, and for the end of a period
  bool told = false;
  while (const std::optional<SessionTime> begun = shared.time()) {
    const SteadyClock::time_point started = SteadyClock::now();
    told = shared.tool.take() || told;
    const auto job = told ? shared.stage->take(*begun, shared.tool.current()) : std::nullopt;
    if (job)
      shared.stage->hand_over(
          shared.stage->run(*job, [&](core::StageStep) { return shared.time().value_or(job->begun); }));
    shared.wait_until(started + (job ? shared.stage->period() : kLook));
  }
  const std::lock_guard lock(shared.mutex);
  shared.ended = true;
  shared.changed.notify_all();
}

}  // namespace telepalp::station
