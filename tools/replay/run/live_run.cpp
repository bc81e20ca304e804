#include "tools/replay/run/live_run.h"

#include <span>
#include <utility>

namespace telepalp::replay {

Result<RunResult> run_live(Tape& tape, const RunSettings& settings, const Scenario& scenario, LiveNetwork network,
                           const std::vector<TickRecord>& unimpaired) {
  const SessionTime end = kBegin + from_seconds(settings.seconds);
  Result<TapeFrames> frames = tape.read_until(end);
  if (!frames) return frames.error();
  const auto placed = first_placement(settings.scene, *frames);
  if (!placed) return nowhere_to_place();
  Cell cell({settings.scene, settings.surface, *placed, settings.recorded}, scenario, tape.settings(), tape.truth(), {},
            std::move(network.wires));
  FigureSum sum;
  std::vector<TickRecord> ticks;
  TapeFrames captured = std::move(*frames);
  std::size_t at = 0;
  for (SessionTime now = kBegin; now < end && at < unimpaired.size(); now += kTick, ++at) {
    network.await(now - kBegin);
    ticks.clear();
    cell.run_until(now + kTick, std::exchange(captured, {}), ticks);
    sum.add(ticks, std::span(unimpaired).subspan(at, 1));
    sum.add(cell.touchable());
  }
  return RunResult{sum.figures(cell), cell.costs()};
}

}  // namespace telepalp::replay
