#pragma once

#include <functional>
#include <vector>

#include "tools/replay/figures/figures.h"

namespace telepalp::replay {

/// What to run: a source, a scene and a hand. They are the same for each network.
struct RunSettings {
  const scenes::Scene& scene;
  surface::SurfaceSettings surface;
  const RecordedHand* recorded = nullptr;  ///< nullptr: examining_hand()
  double seconds = 0.0;                    ///< 0: to the end of the source
  int threads = 1;                         ///< has no influence on any result
};

/// One network to run the source over.
struct RunOrder {
  Scenario scenario;
  Publish publish = {};  ///< called on one thread at a time, in the order of the session
  std::function<void(const std::vector<TickRecord>&)> on_ticks = {};  ///< called with each window of ticks, likewise
};

struct RunResult {
  Figures figures;
  Stopwatch costs;
};

struct RunResults {
  std::vector<RunResult> runs;  ///< in the order of the orders; the first is the unimpaired one
  Stopwatch tape_costs;
  double seconds = 0.0;  ///< of session time
};

/// Runs the tape over the networks of `orders`, side by side, window by window: the tape is read once, and memory holds
/// a few windows at any length. The first order is what the others are compared with. `progress`: called after each
/// window with the session time that is done. Error: the source has no frame in which the scene can be placed, or
/// cannot be read on.
[[nodiscard]] Result<RunResults> run_session(Tape& tape, const RunSettings& settings, std::vector<RunOrder> orders,
                                             const std::function<void(double seconds)>& progress = {});

}  // namespace telepalp::replay
