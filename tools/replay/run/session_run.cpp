#include "tools/replay/run/session_run.h"

#include <cmath>
#include <deque>
#include <optional>
#include <utility>

#include "haptic_station/station/rigs/placement.h"
#include "proto/words/demand.h"
#include "support/program/parallel.h"
#include "tools/replay/run/running.h"

namespace telepalp::replay {
namespace {

/// The work is a pipeline: in one step the tape reads window k + 1, the unimpaired run does window k, and all others do
/// window k - 1, whose unimpaired ticks are known. No task reads what another task of the same step writes.
class Pipeline {
 public:
  Pipeline(Tape& tape, const RunSettings& settings, std::vector<RunOrder> orders)
      : tape_(tape), settings_(settings), orders_(std::move(orders)) {}

  Result<RunResults> run(const std::function<void(double)>& progress) {
    if (const Result<void> started = start(); !started) return started.error();
    while (!next_.empty() || current_ || previous_) {
      if (settings_.stop != nullptr && *settings_.stop)
        return Error{.what = "stopped before its end", .where = "the replay", .fix = "give the same command again"};
      step();
      if (failure_) return *failure_;
      if (progress) progress(to_seconds(done_until_ - kBegin));
    }
    return results();
  }

 private:
  Result<void> read_next();
  Result<void> start();
  void step();
  [[nodiscard]] RunResults results() const;

  Tape& tape_;
  const RunSettings& settings_;
  std::vector<RunOrder> orders_;
  SessionTime read_until_ = kBegin;
  std::deque<TapeWindow> next_;         // read and not begun
  std::optional<TapeWindow> current_;   // of the unimpaired run
  std::optional<TapeWindow> previous_;  // of the others
  std::vector<TickRecord> unimpaired_;  // of previous_
  std::deque<Running> runs_;
  SessionTime done_until_ = kBegin;
  std::optional<Error> failure_;
};

Result<void> Pipeline::read_next() {
  Result<std::optional<TapeWindow>> window = read_window(tape_, read_until_, end_of(settings_.seconds));
  if (!window) return window.error();
  if (*window) next_.push_back(std::move(**window));
  return {};
}

/// Reads up to the first frame in which the scene can be placed. All runs get this place, so that they differ by
/// nothing but the network.
Result<void> Pipeline::start() {
  while (!tape_.ended() && to_seconds(read_until_ - kBegin) < kLongestStart_s &&
         read_until_ < end_of(settings_.seconds)) {
    if (const Result<void> read = read_next(); !read) return read.error();
    const auto placed = first_placement(settings_.scene, next_.back().frames);
    if (!placed) continue;
    const StationSetup setup{settings_.scene, settings_.surface, *placed, settings_.recorded};
    for (RunOrder& order : orders_) runs_.emplace_back(setup, std::move(order), tape_);
    return {};
  }
  return nowhere_to_place();
}

void Pipeline::step() {
  if (!current_ && !next_.empty()) {
    current_ = std::move(next_.front());
    next_.pop_front();
  }
  const int others = static_cast<int>(runs_.size()) - 1;
  program::for_each_parallel(2 + others, settings_.threads, [this](int i) {
    if (i == 0) {
      if (next_.empty())
        if (const Result<void> read = read_next(); !read) failure_ = read.error();
    } else if (i == 1) {
      if (current_) runs_.front().run_until(current_->until, current_->frames);
    } else if (previous_) {
      Running& run = runs_[static_cast<std::size_t>(i - 1)];
      run.run_until(previous_->until, previous_->frames);
      run.sum_up(unimpaired_);
    }
  });
  if (previous_) done_until_ = previous_->until;
  if (current_) {
    runs_.front().sum_up(runs_.front().ticks);
    unimpaired_ = runs_.front().ticks;
  }
  previous_ = std::exchange(current_, std::nullopt);
}

RunResults Pipeline::results() const {
  RunResults results{
      .runs = {}, .tape_costs = tape_.costs(), .images = tape_.images(), .seconds = to_seconds(done_until_ - kBegin)};
  for (const Running& run : runs_) results.runs.push_back(run.result());
  return results;
}

}  // namespace

Result<std::optional<TapeWindow>> read_window(Tape& tape, SessionTime& read_until, SessionTime end) {
  if (tape.ended() || read_until >= end) return std::optional<TapeWindow>();
  const SessionTime until = std::min(read_until + kWindow, end);
  Result<TapeFrames> frames = tape.read_until(until);
  if (!frames) return frames.error();
  read_until = until;
  return std::optional(TapeWindow{until, std::move(*frames)});
}

std::optional<Transform<HapticBase, DepthCamera>> first_placement(const scenes::Scene& scene,
                                                                  const TapeFrames& frames) {
  for (const auto& taped : frames)
    if (auto placed = station::placed(scene, taped->frame.depth, taped->frame.camera.depth)) return placed;
  return std::nullopt;
}

Error nowhere_to_place() {
  return {.what = "the depth images have no measurement around their centre, where the patient should be",
          .where = "the source's first 10 s",
          .fix = "give a source whose camera is aimed at the patient"};
}

Result<RunResults> run_session(Tape& tape, const RunSettings& settings, std::vector<RunOrder> orders,
                               const std::function<void(double seconds)>& progress) {
  demand(!orders.empty(), "there is a first run, the unimpaired one");
  return Pipeline(tape, settings, std::move(orders)).run(progress);
}

}  // namespace telepalp::replay
