#pragma once

#include <atomic>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/report/compare/gate.h"
#include "support/nats/nats_address.h"
#include "support/program/options.h"
#include "tools/replay/figures/assertion.h"
#include "tools/replay/run/session_run.h"
#include "tools/replay/words/sweep_axes.h"

namespace telepalp::replay {

/// Options of a command line by name, without the dashes.
using RunOptions = std::map<std::string, std::string>;

/// A checked command line of telepalp-replay.
struct Request {
  std::string source;
  std::string source_digest;  ///< content_digest.h
  std::filesystem::path scene_file;
  std::string scene_text;
  std::string command;                         ///< the command line, to paste
  RunOptions options;                          ///< all options on which the result depends, with their defaults
  std::unique_ptr<const scenes::Scene> scene;  // at one address, because the runs refer to it
  surface::SurfaceSettings surface;
  Scenario scenario;
  TapeSettings tape;
  RecordedHand recorded;  ///< empty: the simulated hand repeats scenario.hand
  double seconds = 0.0;
  int threads = 1;
  std::filesystem::path journal;  ///< of a station, to be computed again; empty: none
  std::filesystem::path out;      ///< empty: no files
  std::vector<Assertion> assertions;
  std::filesystem::path junit;     ///< empty: none
  std::filesystem::path baseline;  ///< session that the run is compared with; empty: none
  std::vector<report::Tolerance> tolerances;
  std::vector<SweepAxis> axes;           ///< of a sweep; empty: one run
  std::vector<SweepCell> cells;          ///< of the sweep
  std::optional<nats::Address> workers;  ///< the cluster of the sweep's workers; nullopt: this program makes all cells
  std::optional<int> storm_seeds;        ///< number of random cases to check (storm.h) instead of a run
  bool check = false;                    ///< check the invariants at each tick
  bool json = false;

  [[nodiscard]] RunSettings run_settings(const std::atomic<bool>* stop = nullptr) const {
    return {.scene = *scene,
            .surface = surface,
            .recorded = recorded.empty() ? nullptr : &recorded,
            .seconds = seconds,
            .threads = threads,
            .stop = stop};
  }
};

[[nodiscard]] program::Usage usage();

/// The options on which the result of a run depends, beside its source.
[[nodiscard]] std::vector<std::string_view> names_of_run_options();

/// Reads the whole command line before anything runs. Error: an argument is misspelt, missing or out of range.
[[nodiscard]] Result<Request> read_request(const program::Arguments& arguments);

}  // namespace telepalp::replay
