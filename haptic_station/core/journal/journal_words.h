#pragma once

#include <array>
#include <optional>

#include "haptic_station/core/collision_stage.h"
#include "haptic_station/core/journal/journal_tick.h"
#include "haptic_station/core/surface_stage.h"
#include "messages/journal.pb.h"

namespace telepalp::core {

/// The times of a run's steps, as a driver gave them to the stage.
class StepTimes {
 public:
  SessionTime keep(StageStep step, SessionTime at) noexcept { return at_[static_cast<std::size_t>(step)] = at; }
  [[nodiscard]] SessionTime of(StageStep step) const noexcept { return at_[static_cast<std::size_t>(step)]; }

 private:
  std::array<SessionTime, 3> at_{};
};

[[nodiscard]] msg::JournalTick message_of(const JournalTick& tick);
[[nodiscard]] msg::JournalSurfaceRun message_of(const SurfaceStage::Job& job, const StepTimes& times,
                                                const SurfaceStage::Result& result);
[[nodiscard]] msg::JournalCollisionRun message_of(const CollisionStage::Job& job, const CollisionStage::Result& result);

/// The inputs of a recorded tick, without its surface. nullopt: the message is malformed.
[[nodiscard]] std::optional<loop::TickIn> tick_in(const msg::JournalTick& tick);
[[nodiscard]] SurfaceStage::Job job_of(const msg::JournalSurfaceRun& run);
[[nodiscard]] StepTimes times_of(const msg::JournalSurfaceRun& run);

}  // namespace telepalp::core
