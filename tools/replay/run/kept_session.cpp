#include "tools/replay/run/kept_session.h"

#include <utility>

namespace telepalp::replay {
namespace {

Error stopped() {
  return {.what = "stopped before its end", .where = "the replay", .fix = "give the same command again"};
}

bool is_set(const std::atomic<bool>* stop) { return stop != nullptr && *stop; }

/// Memory of a window and its unimpaired ticks.
std::size_t bytes_of(const TapeWindow& window) {
  std::size_t bytes = sizeof(TickRecord) * static_cast<std::size_t>(kWindow / kTick);
  for (const auto& taped : window.frames)
    bytes += sizeof(TapeFrame) + taped->frame.depth.samples.size() * sizeof(std::uint16_t) + taped->depth.size() +
             taped->color.size();
  return bytes;
}

}  // namespace

/// Reads the windows of the tape until they need more than `most_B`.
Result<KeptSession::Windows> KeptSession::read_all(Tape& tape, const RunSettings& settings, std::size_t most_B) {
  Windows windows;
  SessionTime read_until = kBegin;
  for (std::size_t bytes = 0; bytes <= most_B;) {
    if (is_set(settings.stop)) return stopped();
    Result<std::optional<TapeWindow>> window = read_window(tape, read_until, end_of(settings.seconds));
    if (!window) return window.error();
    if (!*window) return windows.setup ? Result<Windows>(std::move(windows)) : nowhere_to_place();
    bytes += bytes_of(**window);
    if (!windows.setup)
      if (const auto placed = first_placement(settings.scene, (**window).frames))
        windows.setup.emplace(StationSetup{settings.scene, settings.surface, *placed, settings.recorded});
    if (!windows.setup && to_seconds(read_until - kBegin) >= kLongestStart_s) return nowhere_to_place();
    windows.all.push_back({.tape = std::move(**window)});
  }
  windows.fits = false;
  return windows;
}

Result<void> KeptSession::make_unimpaired(const Scenario& unimpaired, const std::atomic<bool>* stop) {
  Running run(setup_, {.scenario = unimpaired}, tape_);
  for (Window& window : windows_) {
    if (is_set(stop)) return stopped();
    run.run_until(window.tape.until, window.tape.frames);
    run.sum_up(run.ticks);
    window.unimpaired = run.ticks;
  }
  unimpaired_ = run.result();
  return {};
}

Result<std::optional<KeptSession>> KeptSession::make(Tape tape, const RunSettings& settings, const Scenario& unimpaired,
                                                     std::size_t most_B) {
  Result<Windows> windows = read_all(tape, settings, most_B);
  if (!windows) return windows.error();
  if (!windows->fits) return std::optional<KeptSession>();
  KeptSession session(std::move(tape), *std::move(windows));
  if (const Result<void> made = session.make_unimpaired(unimpaired, settings.stop); !made) return made.error();
  return std::optional(std::move(session));
}

Result<RunResults> KeptSession::run(const Scenario& scenario, const std::atomic<bool>* stop) const {
  Running run(setup_, {.scenario = scenario}, tape_);
  for (const Window& window : windows_) {
    if (is_set(stop)) return stopped();
    run.run_until(window.tape.until, window.tape.frames);
    run.sum_up(window.unimpaired);
  }
  return RunResults{.runs = {unimpaired_, run.result()},
                    .tape_costs = tape_.costs(),
                    .images = tape_.images(),
                    .seconds = to_seconds(windows_.back().tape.until - kBegin)};
}

}  // namespace telepalp::replay
