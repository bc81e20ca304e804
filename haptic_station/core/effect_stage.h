#pragma once

#include <algorithm>
#include <any>
#include <memory>
#include <optional>
#include <utility>

#include "haptic_station/core/stage_step.h"
#include "haptic_station/loop/time_line.h"
#include "proto/words/frames.h"
#include "proto/words/latest_value.h"

namespace telepalp::core {

/// Where the tool is, for which a slow stage computes a local model. Frame: H.
struct ToolAt {
  Point<HapticBase> device;
  std::optional<Eigen::Quaterniond> attitude = {};  ///< rotation from the tool's axes to H; nullopt: not measured
};

/// What a stage is asked for: a local model around the tool.
struct ModelWanted {
  ToolAt tool;
  SessionTime begun{};  ///< when the tool was there
  /// From `begun` to the middle of the time in which the effect displays the model: from the end of this run to the end
  /// of the next one, if they take as long as the last one.
  Nanoseconds displayed_in{};
};

/// A slow stage that an effect owns: it computes a local model of the tissue around the tool, once in each period, and
/// hands it over to the effect by LatestValue. It is driven as the other stages are: take(), run(), hand_over(). A
/// period that begins while a run lasts is left out, so a stage that is slower than its period runs back to back, and
/// no backlog grows. Owner: one thread.
class EffectStage {
 public:
  struct Job {
    SessionTime begun{};
    ToolAt tool;
  };
  struct Result {
    std::any model;  ///< the kind's LocalModel; empty: the run found none
    SessionTime done{};
  };

  virtual ~EffectStage() = default;
  /// nullopt: the period of the last run is not over.
  [[nodiscard]] std::optional<Job> take(SessionTime now, const ToolAt& tool) {
    if (loop::begins_new_time_line(now, begun_)) due_ = now;
    if (now < due_) return std::nullopt;
    begun_ = now;
    due_ = now + period();
    return Job{.begun = now, .tool = tool};
  }
  [[nodiscard]] virtual Result run(const Job& job, const StepTime& time) = 0;
  /// The effect takes the model in its next step, if it still exists.
  virtual void hand_over(Result result) = 0;
  [[nodiscard]] virtual Nanoseconds period() const noexcept = 0;

 private:
  SessionTime begun_{};
  SessionTime due_{};
};

/// The slow stage of the effects of one kind, specialised beside the stage:
///   template <> struct SlowStageOf<effects::Needle> { using Stage = NeedleStage; };
/// A stage has kPeriod, is constructed from the kind's Settings, and has std::optional<Kind::LocalModel>
/// model_at(const ModelWanted&), which may take long, and may allocate.
template <class Kind>
struct SlowStageOf;

template <class Kind>
concept OwnsSlowStage = requires {
  typename Kind::LocalModel;
};

/// The slow stage of one effect of kind `Kind`, and its hand-off to this effect.
template <OwnsSlowStage Kind>
class OwnedStage final : public EffectStage {
 public:
  using Model = typename Kind::LocalModel;
  using Stage = typename SlowStageOf<Kind>::Stage;

  OwnedStage(const typename Kind::Settings& settings, std::shared_ptr<LatestValue<Model>> to_effect)
      : stage_(settings), to_effect_(std::move(to_effect)) {}

  [[nodiscard]] Result run(const Job& job, const StepTime& time) override {
    Result result;
    const ModelWanted wanted{
        .tool = job.tool, .begun = job.begun, .displayed_in = took_ + std::max(took_, period()) / 2};
    if (std::optional<Model> model = stage_.model_at(wanted)) result.model = std::move(*model);
    result.done = time(StageStep::Done);
    took_ = std::max(Nanoseconds::zero(), result.done - job.begun);
    return result;
  }
  void hand_over(Result result) override {
    if (result.model.has_value()) to_effect_->put(std::any_cast<Model>(std::move(result.model)));
  }
  [[nodiscard]] Nanoseconds period() const noexcept override { return Stage::kPeriod; }

 private:
  Stage stage_;
  Nanoseconds took_{};                             // the last run
  std::shared_ptr<LatestValue<Model>> to_effect_;  // shared with the effect: a run may end after the effect did
};

}  // namespace telepalp::core
