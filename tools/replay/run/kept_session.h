#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tools/replay/run/running.h"

namespace telepalp::replay {

/// A source with its unimpaired run, kept in memory: a further network then costs its own run alone. Gives the results
/// of run_session(). Owner: one thread.
class KeptSession {
 public:
  /// Reads the whole tape and makes the unimpaired run. `settings`: its scene and hand must outlive this object.
  /// nullopt: frames and ticks would need more than `most_B`. Error: as run_session().
  [[nodiscard]] static Result<std::optional<KeptSession>> make(Tape tape, const RunSettings& settings,
                                                               const Scenario& unimpaired, std::size_t most_B);

  /// The results of run_session() for the unimpaired scenario and this one. `stop`: once true, the run ends with an
  /// error; nullptr: it cannot be stopped.
  [[nodiscard]] Result<RunResults> run(const Scenario& scenario, const std::atomic<bool>* stop) const;

 private:
  /// A window, and the ticks of the unimpaired run in it.
  struct Window {
    TapeWindow tape;
    std::vector<TickRecord> unimpaired{};
  };
  /// The windows of a tape, up to a bound.
  struct Windows {
    std::vector<Window> all{};
    std::optional<StationSetup> setup{};
    bool fits = true;
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
