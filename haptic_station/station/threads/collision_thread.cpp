#include "haptic_station/station/threads/collision_thread.h"

#include <utility>

#include "haptic_station/core/journal/journal_words.h"
#include "haptic_station/station/threads/journal_thread.h"
#include "haptic_station/station/threads/tick_timer.h"

namespace telepalp::station {

CollisionThread::CollisionThread(LatestValue<loop::TouchableSurface>& from_surface,
                                 LatestValue<Point<HapticBase>>& device, LatestValue<loop::TouchableSurface>& to_haptic,
                                 std::function<SessionTime()> now, JournalThread* journal)
    : from_surface_(from_surface),
      device_(device),
      to_haptic_(to_haptic),
      now_(std::move(now)),
      journal_(journal),
      thread_([this] { run(); }) {}

CollisionThread::~CollisionThread() {
  running_ = false;
  thread_.join();
}

void CollisionThread::run() {
  TickTimer timer(TickTimer::Clock::now() + core::CollisionStage::kPeriod, core::CollisionStage::kPeriod);
  while (running_) {
    (void)timer.wait();
    detect();
  }
}

void CollisionThread::detect() {
  std::optional<loop::TouchableSurface> newer;
  if (from_surface_.take()) newer = from_surface_.current();
  (void)device_.take();
  const auto job = stage_.take(now_(), std::move(newer), device_.current());
  const core::CollisionStage::Result result = stage_.run(*job, [this](core::StageStep) { return now_(); });
  if (journal_ != nullptr) journal_->add(message_of(*job, result));  // before a tick can adopt the plane
  if (result.plane) to_haptic_.put(*result.plane);
}

}  // namespace telepalp::station
