#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tools/replay/run/running.h"

namespace telepalp::replay {

/// A source and its unimpaired run in memory, so that another network costs one run only. Gives the same results as
/// run_session(). Owner: one thread.
class KeptSession {
 public:
  /// Reads the whole tape and makes the unimpaired run. `settings`: its scene and hand must outlive this object.
  /// nullopt if frames and ticks would need more than `most_B`. Error: as run_session().
  [[nodiscard]] static Result<std::optional<KeptSession>> make(Tape tape, const RunSettings& settings,
                                                               const Scenario& unimpaired, std::size_t most_B);

  /// As run_session() for the unimpaired scenario and this one. `stop`: once true, the run ends with an error; nullptr:
  /// the run cannot be stopped.
  [[nodiscard]] Result<RunResults> run(const Scenario& scenario, const std::atomic<bool>* stop) const;

 private:
  /// A window, and the ticks of the unimpaired run in it.
  struct Window {
    TapeWindow tape;
    std::vector<TickRecord> unimpaired{};
  };
  struct Windows {
    std::vector<Window> all{};
    std::optional<StationSetup> setup{};  ///< with the place of the scene, from the first frame that shows one
    bool fits = true;                     ///< false: the tape needs more memory, and was not read to its end
  };
  static Result<Windows> read_all(Tape& tape, const RunSettings& settings, std::size_t most_B);
  KeptSession(Tape tape, Windows windows)
      : tape_(std::move(tape)), setup_(*windows.setup), windows_(std::move(windows.all)) {}
  Result<void> make_unimpaired(const Scenario& unimpaired, const std::atomic<bool>* stop);

  Tape tape_;
  StationSetup setup_;
  std::vector<Window> windows_;
  RunResult unimpaired_;
};

}  // namespace telepalp::replay
