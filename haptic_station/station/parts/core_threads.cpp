#include "haptic_station/station/parts/core_threads.h"

#include <utility>

#include "haptic_station/station/rigs/scene_rig.h"

namespace telepalp::station {

CoreThreads::CoreThreads(const scenes::Scene& scene, bool in_tick, std::unique_ptr<ports::Rig> rig,
                         JournalThread* journal)
    : in_tick_(in_tick),
      journal_(journal),
      effects_(core::build_effects(scene.effects)),
      loop_(loop_of(scene, effects_.bank)),
      rig_(std::move(rig)) {}

void CoreThreads::start_surface(const surface::SurfaceSettings& settings, core::SurfaceStage::Placement placement,
                                SurfaceWorker::Handlers handlers) {
  worker_.emplace(settings, std::move(placement), std::move(handlers), in_tick_ ? surfaces_ : slow_surfaces_,
                  device_to_surface_, effects_.bank);
  if (journal_ != nullptr) worker_->write_to(*journal_);
}

Result<RealtimeGrant> CoreThreads::start_haptic(Realtime realtime, Nanoseconds clock_offset,
                                                std::function<SessionTime()> now) {
  haptic_.emplace(loop_, *rig_, surfaces_, ticks_, device_to_surface_);
  haptic_->set_clock_offset(clock_offset);
  if (journal_ != nullptr) haptic_->write_to(*journal_);
  for (std::unique_ptr<core::EffectStage>& stage : effects_.stages) {
    slow_effects_.push_back(std::make_unique<EffectStageThread>(std::move(stage), now));
    haptic_->tell(slow_effects_.back()->tool());
  }
  if (!in_tick_) collision_.emplace(slow_surfaces_, haptic_->device(), surfaces_, std::move(now), journal_);
  return haptic_->start(realtime);
}

/// The collision thread reads a hand-off of the haptic thread, so it ends first. The haptic thread writes into
/// hand-offs of the slow effects' threads, so these end after it.
void CoreThreads::end() {
  collision_.reset();
  haptic_.reset();
  slow_effects_.clear();
  worker_.reset();
}

}  // namespace telepalp::station
