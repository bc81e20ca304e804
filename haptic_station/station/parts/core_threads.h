#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/rigs/static_patient.h"
#include "haptic_station/station/threads/collision_thread.h"
#include "haptic_station/station/threads/effect_stage_thread.h"
#include "haptic_station/station/threads/haptic_thread.h"
#include "haptic_station/station/threads/surface_worker.h"

namespace telepalp::station {

/// Drives the station's core live: the surface, collision and haptic threads, those of slow effects, and the hand-offs
/// between them. Owner: network thread.
class CoreThreads {
 public:
  /// `in_tick`: the haptic thread evaluates the surface, so there is no collision thread. `journal`: keeps all that the
  /// core is given, and outlives this object; nullptr: none is kept.
  CoreThreads(const scenes::Scene& scene, bool in_tick, std::unique_ptr<ports::Rig> rig, JournalThread* journal);
  ~CoreThreads() { end(); }
  CoreThreads(const CoreThreads&) = delete;
  CoreThreads& operator=(const CoreThreads&) = delete;

  void start_surface(const surface::SurfaceSettings& settings, core::SurfaceStage::Placement placement,
                     SurfaceWorker::Handlers handlers);
  /// Starts the haptic thread and the threads that it needs: collision detection, if the setting asks for it, and the
  /// effects' slow stages. `now`: the session clock, called on these threads. Error: as for HapticThread::start().
  [[nodiscard]] Result<RealtimeGrant> start_haptic(Realtime realtime, Nanoseconds clock_offset,
                                                   std::function<SessionTime()> now);
  /// Hands over the surface of a static model. There is no surface thread without a camera, so the network thread does.
  void touch(const StaticPatient& model) { surfaces_.put({model.snapshot, model.haptic_from_model}); }
  /// Ends the threads. Nothing of theirs is called any more.
  void end();

  [[nodiscard]] SurfaceWorker& surface() noexcept { return *worker_; }
  /// nullptr before start_haptic().
  [[nodiscard]] HapticThread* haptic() noexcept { return haptic_ ? &*haptic_ : nullptr; }
  [[nodiscard]] TickRing& ticks() noexcept { return ticks_; }

 private:
  const bool in_tick_;
  JournalThread* journal_;
  LatestValue<loop::TouchableSurface> slow_surfaces_;  // surface thread to collision thread, if it exists
  LatestValue<loop::TouchableSurface> surfaces_;       // surface, collision or network to haptic thread
  LatestValue<Point<HapticBase>> device_to_surface_;   // haptic thread to surface thread
  TickRing ticks_;                                     // haptic thread to network thread
  core::BuiltEffects effects_;                         // the loop steps a copy of the bank
  loop::HapticLoop loop_;                              // owner: haptic thread, once it runs
  std::unique_ptr<ports::Rig> rig_;                    // owner: haptic thread, once it runs
  std::optional<HapticThread> haptic_;
  std::optional<CollisionThread> collision_;
  std::vector<std::unique_ptr<EffectStageThread>> slow_effects_;
  std::optional<SurfaceWorker> worker_;
};

}  // namespace telepalp::station
