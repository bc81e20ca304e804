#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "tools/replay/figures/figures.h"

namespace telepalp::replay {

/// The settings that all runs share.
struct RunSettings {
  const scenes::Scene& scene;
  surface::SurfaceSettings surface;
  const RecordedHand* recorded = nullptr;   ///< nullptr: the scenario's script
  double seconds = 0.0;                     ///< 0: to the end of the source
  int threads = 1;                          ///< has no influence on any result
  const std::atomic<bool>* stop = nullptr;  ///< once true, the run ends with an error; nullptr: it cannot be stopped
};

/// One network to run the source over.
struct RunOrder {
  Scenario scenario;
  Publish publish = {};  ///< called with each message in order, on one thread at a time
  std::function<void(const std::vector<TickRecord>&)> on_ticks =
      {};  ///< called with the ticks of each window in order, on one thread at a time
};

struct RunResult {
  Figures figures;
  Stopwatch costs;
};

struct RunResults {
  std::vector<RunResult> runs;  ///< one per RunOrder, in the same order; the first is the unimpaired run
  Stopwatch tape_costs;
  ImageFacts images{};   ///< that the tape read
  double seconds = 0.0;  ///< of session time
};

/// The camera's pose in the haptic base's frame, from the first of `frames` in which the scene can be placed; a scene
/// that asks for centring needs measured depth around the image centre. nullopt: no such frame.
[[nodiscard]] std::optional<Transform<HapticBase, DepthCamera>> first_placement(const scenes::Scene& scene,
                                                                                const TapeFrames& frames);
[[nodiscard]] Error nowhere_to_place();

/// Runs the source's frames (`tape`) over the networks of `orders`, side by side, in windows of 0.5 s: the tape is read
/// once, and memory holds the frames of a few windows. All other runs are compared with the run of the first order.
/// `progress`: called after each window with the session time replayed so far [s]. Error: the scene can be placed in no
/// frame of the source's first 10 s, or the source cannot be read.
[[nodiscard]] Result<RunResults> run_session(Tape& tape, const RunSettings& settings, std::vector<RunOrder> orders,
                                             const std::function<void(double seconds)>& progress = {});

}  // namespace telepalp::replay
