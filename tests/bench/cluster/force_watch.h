#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "haptic_station/scenes/scene.h"
#include "proto/wire/message.h"
#include "proto/words/result.h"
#include "tools/replay/storm/storm.h"

namespace telepalp::bench {

/// What the recorded ticks of a live station say of its force.
struct ForceFacts {
  std::uint64_t ticks = 0;
  std::uint64_t missing = 0;   ///< ticks that are not in the recording, between two that are
  std::uint64_t touching = 0;  ///< ticks in contact
  std::uint64_t faults = 0;    ///< events of a fault, and ticks in phase Faulted
  double most_N = 0.0;
  std::optional<replay::Invariants::Violation> violation;  ///< the first
};

/// Judges the ticks of a station by the rules that storms check in virtual time: the force is finite and at most the
/// scene's peak, changes in a tick by no more than motion and limiter explain, and ends when the surface is too old. In
/// virtual time no tick is late. Before a tick that is late or follows missing ones, this class inserts ticks on the
/// straight line from the tick before, so that a change in 3 ms is not judged as one in 0.5 ms.
class ForceWatch {
 public:
  explicit ForceWatch(const scenes::Scene& scene);
  void add(const wire::Message& message);
  [[nodiscard]] const ForceFacts& facts() const noexcept { return facts_; }

 private:
  void add(const msg::StationTicks& ticks);
  struct Ages {
    double surface_s = 0.0;
    double hand_s = 0.0;
  };
  /// Periods from the tick before to tick `i`.
  [[nodiscard]] std::uint64_t periods_until(const msg::StationTicks& ticks, int i);
  /// `periods`: since the tick before, at least 1.
  void judge(const replay::TickRecord& tick, std::uint64_t periods);

  replay::Invariants invariants_;
  replay::TickRecord last_{};
  Ages ages_{};
  double next_tick_ns_ = 0.0;  ///< session time at which the next tick is due
  std::uint64_t next_tick_ = 0;
  ForceFacts facts_;
};

/// The facts of a whole recording of a station with the scene `palpation`. Error: it cannot be read.
[[nodiscard]] Result<ForceFacts> force_facts(const std::filesystem::path& session);

}  // namespace telepalp::bench
