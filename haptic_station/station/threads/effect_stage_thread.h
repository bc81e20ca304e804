#pragma once

#include <functional>
#include <memory>
#include <thread>

#include "haptic_station/core/effect_stage.h"
#include "proto/words/latest_value.h"

namespace telepalp::station {

/// Runs the slow stage of an effect on a thread of its own, once in each of its periods. A run that does not end blocks
/// nothing but its stage: the destructor waits for 0.2 s, then leaves the thread behind, which owns all that it uses.
/// What such a run hands over later reaches no effect that is still stepped. Owner: one thread.
class EffectStageThread {
 public:
  /// `now`: the session clock, called on this thread, never after the destructor.
  EffectStageThread(std::unique_ptr<core::EffectStage> stage, std::function<SessionTime()> now);
  ~EffectStageThread();
  EffectStageThread(const EffectStageThread&) = delete;
  EffectStageThread& operator=(const EffectStageThread&) = delete;

  /// Where the tool is, at each tick. Written by: haptic thread. The first run waits for it.
  [[nodiscard]] LatestValue<core::ToolAt>& tool() noexcept;

 private:
  struct Shared;
  static void run(Shared& shared);

  std::shared_ptr<Shared> shared_;  // shared with the thread, which may be left behind
  std::thread thread_;
};

}  // namespace telepalp::station
