#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "haptic_station/core/collision_stage.h"
#include "haptic_station/core/journal/journal_file.h"
#include "haptic_station/core/surface_stage.h"
#include "haptic_station/loop/haptic_loop.h"

namespace telepalp::core {

/// A station's journal against the core, tick by tick. Two values are equal if all their bits are.
struct JournalVerdict {
  std::uint64_t ticks = 0;  ///< replayed
  std::uint64_t forces_differ = 0;
  std::uint64_t phases_differ = 0;
  std::uint64_t proxies_differ = 0;
  std::optional<std::uint64_t> first_difference;  ///< number of the first tick that differs
  std::uint64_t surface_runs = 0;
  std::uint64_t collision_runs = 0;
  std::optional<std::string> stopped;  ///< why the replay ended before the journal, with the tick; nullopt: it did not

  [[nodiscard]] bool equal() const noexcept {
    return forces_differ + phases_differ + proxies_differ == 0 && !stopped && ticks > 0;
  }
};

/// Feeds a journal to the core: the third driver beside threads and virtual time. The stages and the loop must be new,
/// and made from the journal's header.
class JournalReplay {
 public:
  /// Called after each tick with the recorded tick and the force that the core computed again [N, in H].
  using OnTick = std::function<void(const msg::JournalTick&, const Eigen::Vector3d& force_N)>;

  /// `collision`: nullptr if the surface setting is evaluated in the tick.
  JournalReplay(loop::HapticLoop& loop, SurfaceStage& surfaces, CollisionStage* collision, OnTick on_tick = {});

  /// Replays all blocks of `reader`.
  [[nodiscard]] JournalVerdict run(JournalReader& reader);

 private:
  using Surfaces = std::map<std::uint64_t, loop::TouchableSurface>;

  void run_surface(const msg::JournalSurfaceRun& run);
  void run_collision(const msg::JournalCollisionRun& run);
  void tick_on();
  bool tick(const msg::JournalTick& recorded);
  void compare(const msg::JournalTick& recorded, const loop::TickOut& out);
  void stop_at(const msg::JournalTick& tick);
  bool stops_at_a_gap(const msg::JournalTick& recorded);
  [[nodiscard]] Surfaces& for_ticks() noexcept { return collision_ == nullptr ? made_ : planes_; }

  loop::HapticLoop& loop_;
  SurfaceStage& surfaces_;
  CollisionStage* collision_;
  OnTick on_tick_;
  Surfaces made_;                   // of the surface stage, by number
  Surfaces planes_;                 // of the collision stage, by number
  loop::TouchableSurface adopted_;  // the loop refers to it
  std::uint64_t surfaces_made_ = 0;
  std::optional<std::string> broken_;     // why no further surface can be made, to follow "which"
  std::deque<msg::JournalTick> waiting_;  // ticks whose surface may come with a later block
  JournalVerdict verdict_;
};

}  // namespace telepalp::core
