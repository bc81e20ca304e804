#include "tools/replay/run/session_run.h"

#include <cmath>
#include <deque>
#include <optional>
#include <utility>

#include "haptic_station/station/rigs/placement.h"
#include "proto/words/demand.h"
#include "support/program/parallel.h"

namespace telepalp::replay {
namespace {

constexpr Nanoseconds kWindow{500'000'000};
constexpr double kLongestStart_s = 10.0;  // of frames in which the scene cannot be placed

/// One run with its cell, its figures and its recent ticks.
struct Running {
  Running(const StationSetup& setup, RunOrder& order, const Tape& tape)
      : cell(setup, order.scenario, tape.settings(), tape.truth(), std::move(order.publish),
             simulated_wires(order.scenario)),
        on_ticks(std::move(order.on_ticks)) {}

  void run_until(SessionTime until, const TapeFrames& frames) {
    ticks.clear();
    cell.run_until(until, frames, ticks);
    if (on_ticks) on_ticks(ticks);
  }
  void sum_up(const std::vector<TickRecord>& unimpaired) {
    sum.add(ticks, unimpaired);
    sum.add(cell.touchable());
  }

  Cell cell;
  std::function<void(const std::vector<TickRecord>&)> on_ticks;
  std::vector<TickRecord> ticks;
  FigureSum sum;
};

/// Frames of one window of session time.
struct TapeWindow {
  SessionTime until;
  TapeFrames frames;
};

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
  [[nodiscard]] SessionTime end() const noexcept {
    return settings_.seconds > 0.0 ? kBegin + from_seconds(settings_.seconds) : SessionTime::max();
  }
  Result<void> read_window();
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

Result<void> Pipeline::read_window() {
  if (tape_.ended() || read_until_ >= end()) return {};
  const SessionTime until = std::min(read_until_ + kWindow, end());
  Result<TapeFrames> frames = tape_.read_until(until);
  if (!frames) return frames.error();
  read_until_ = until;
  next_.push_back({until, std::move(*frames)});
  return {};
}

/// Reads up to the first frame in which the scene can be placed. All runs get this place, so that they differ by
/// nothing but the network.
Result<void> Pipeline::start() {
  while (!tape_.ended() && to_seconds(read_until_ - kBegin) < kLongestStart_s && read_until_ < end()) {
    if (const Result<void> read = read_window(); !read) return read.error();
    const auto placed = first_placement(settings_.scene, next_.back().frames);
    if (!placed) continue;
    const StationSetup setup{settings_.scene, settings_.surface, *placed, settings_.recorded};
    for (RunOrder& order : orders_) runs_.emplace_back(setup, order, tape_);
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
        if (const Result<void> read = read_window(); !read) failure_ = read.error();
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
  for (const Running& run : runs_) results.runs.push_back({run.sum.figures(run.cell), run.cell.costs()});
  return results;
}

}  // namespace

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
