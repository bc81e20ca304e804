#pragma once

#include <optional>
#include <utility>

#include "haptic_station/core/stage_step.h"

namespace telepalp::core {

/// The cost of a stage that never ends a run.
inline constexpr Nanoseconds kNever = Nanoseconds::max();

/// Drives a stage in virtual time. A run takes effect when its cost is over; meanwhile, what arrives at the stage waits
/// there. A run that never ends blocks its stage, as a thread that hangs does, and nothing else. Owner: one thread.
template <class Stage>
class VirtualDriver {
 public:
  using Result = typename Stage::Result;

  /// The result to hand over at `now`, once its run is over; nullopt: the stage is idle or at work.
  [[nodiscard]] std::optional<Result> finished(SessionTime now) {
    if (!in_work_ || in_work_->done > now) return std::nullopt;
    return std::exchange(in_work_, std::nullopt);
  }

  /// If the stage is idle, takes a job with `inputs` and runs it. `cost`: Nanoseconds(StageStep), the time from the
  /// run's begin to a step; called when the stage has done this step.
  template <class Cost, class... Inputs>
  void begin(SessionTime now, Stage& stage, const Cost& cost, Inputs&&... inputs) {
    if (in_work_) return;
    if (const auto job = stage.take(now, std::forward<Inputs>(inputs)...))
      in_work_ = stage.run(*job, [&](StageStep reached) { return after(now, cost(reached)); });
  }

  /// Drops the result that is not handed over yet: the scene was read again, and a new stage takes the old one's place.
  void drop() { in_work_.reset(); }
  [[nodiscard]] bool is_idle() const noexcept { return !in_work_; }

 private:
  [[nodiscard]] static SessionTime after(SessionTime begun, Nanoseconds cost) noexcept {
    return cost == kNever ? SessionTime::max() : begun + cost;
  }
  std::optional<Result> in_work_;
};

/// Runs a stage at once and without cost, for a simulation that gives the stage no time; nullopt: it has no job.
template <class Stage, class... Inputs>
std::optional<typename Stage::Result> run_at_once(Stage& stage, SessionTime now, Inputs&&... inputs) {
  const auto job = stage.take(now, std::forward<Inputs>(inputs)...);
  if (!job) return std::nullopt;
  return stage.run(*job, [now](StageStep) { return now; });
}

}  // namespace telepalp::core
