#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "support/program/options.h"
#include "tools/replay/figures/assertion.h"
#include "tools/replay/run/session_run.h"
#include "tools/replay/words/sweep_axes.h"

namespace telepalp::replay {

/// A checked command line of telepalp-replay.
struct Request {
  std::string source;
  std::filesystem::path scene_file;
  std::unique_ptr<const scenes::Scene> scene;  // at one address, because the runs refer to it
  surface::SurfaceSettings surface;
  Scenario scenario;
  TapeSettings tape;
  RecordedHand recorded;  ///< empty: the simulated hand repeats scenario.hand
  double seconds = 0.0;
  int threads = 1;
  std::filesystem::path out;  ///< empty: no files
  std::vector<Assertion> assertions;
  std::filesystem::path junit;     ///< empty: none
  std::vector<SweepAxis> axes;     ///< of a sweep; empty: one run
  std::vector<SweepCell> cells;    ///< of the sweep
  std::optional<int> storm_seeds;  ///< number of random cases to check (storm.h) instead of a run
  bool check = false;              ///< check the invariants at each tick
  bool json = false;

  [[nodiscard]] RunSettings run_settings() const {
    return {.scene = *scene,
            .surface = surface,
            .recorded = recorded.empty() ? nullptr : &recorded,
            .seconds = seconds,
            .threads = threads};
  }
};

[[nodiscard]] program::Usage usage();

/// Reads the whole command line before anything runs. Error: an argument is misspelt, missing or out of range.
[[nodiscard]] Result<Request> read_request(const program::Arguments& arguments);

}  // namespace telepalp::replay
