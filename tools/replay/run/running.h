#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "tools/replay/run/session_run.h"
#include "tools/replay/source/tape.h"

namespace telepalp::replay {

/// A tape is read, and its runs advance, in steps of this session time.
inline constexpr Nanoseconds kWindow{500'000'000};
inline constexpr double kLongestStart_s = 10.0;  ///< the scene must find its place in the frames of this time

/// Frames of one window of session time.
struct TapeWindow {
  SessionTime until;
  TapeFrames frames;
};

/// The session time at which a run of `seconds` ends; 0 s: at the end of its source.
[[nodiscard]] inline SessionTime end_of(double seconds) noexcept {
  return seconds > 0.0 ? kBegin + from_seconds(seconds) : SessionTime::max();
}

/// Reads the window that begins at `read_until`, and moves `read_until` to its end. nullopt: `tape` or `end` is
/// reached.
[[nodiscard]] Result<std::optional<TapeWindow>> read_window(Tape& tape, SessionTime& read_until, SessionTime end);

/// One run with its cell, its figures and its recent ticks.
struct Running {
  Running(const StationSetup& setup, RunOrder order, const Tape& tape)
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
  [[nodiscard]] RunResult result() const { return {sum.figures(cell), cell.costs()}; }

  Cell cell;
  std::function<void(const std::vector<TickRecord>&)> on_ticks;
  std::vector<TickRecord> ticks;
  FigureSum sum;
};

}  // namespace telepalp::replay
