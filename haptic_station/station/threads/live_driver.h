#pragma once

#include <functional>
#include <stop_token>
#include <utility>

#include "haptic_station/station/threads/stage_thread.h"

namespace telepalp::station {

/// Drives a stage of the core live: takes its jobs on the owner's thread, runs them on a StageThread, and hands each
/// result over on the owner's thread. While a run lasts, no job is taken: a stage slower than its period queues
/// nothing. Owner: the thread that owns the stage.
template <class Stage>
class LiveDriver {
 public:
  using Result = typename Stage::Result;

  /// `stage` and `thread` outlive this object; `thread` must end before it.
  LiveDriver(Stage& stage, StageThread& thread, std::function<void(Result)> hand_over)
      : stage_(stage), thread_(thread), hand_over_(std::move(hand_over)) {}
  LiveDriver(const LiveDriver&) = delete;
  LiveDriver& operator=(const LiveDriver&) = delete;

  /// If the stage is idle, takes a job with `inputs` and begins its run.
  template <class... Inputs>
  void begin(SessionTime now, Inputs&&... inputs) {
    if (at_work_) return;
    auto job = stage_.take(now, std::forward<Inputs>(inputs)...);
    if (!job) return;
    at_work_ = true;
    thread_.run([this, job = std::move(*job)](const core::StepTime& time, const std::stop_token& stop) {
      return StageThread::HandOver([this, result = run(job, time, stop)] {
        at_work_ = false;
        hand_over_(result);
      });
    });
  }

 private:
  Result run(const typename Stage::Job& job, const core::StepTime& time, const std::stop_token& stop) {
    if constexpr (requires { stage_.run(job, time, stop); })
      return stage_.run(job, time, stop);
    else
      return stage_.run(job, time);
  }

  Stage& stage_;
  StageThread& thread_;
  std::function<void(Result)> hand_over_;
  bool at_work_ = false;
};

}  // namespace telepalp::station
