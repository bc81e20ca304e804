#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "proto/words/clock_envelope.h"
#include "proto/words/time.h"

namespace telepalp::capture {

/// Maps a driver's timestamps, of any epoch, to session time: the offset follows the least delayed arrivals
/// (ClockEnvelope). A driver clock that steps back or leaps ahead (a recording that starts over, a device that resets)
/// starts a new mapping. Session times never go backwards.
class TimestampMap {
 public:
  /// The session time of a frame with the driver's stamp `driver` that arrived at `arrival`. The result is at most
  /// `arrival`, unless an earlier result was later: then it is the earlier result plus 1 ns.
  [[nodiscard]] SessionTime map(std::chrono::microseconds driver, SessionTime arrival);

  /// Number of jumps of the driver's clock.
  [[nodiscard]] std::uint64_t jumps() const noexcept { return envelope_.jumps(); }

 private:
  ClockEnvelope envelope_;
  std::optional<std::chrono::microseconds> last_driver_;
  std::optional<SessionTime> last_;
};

}  // namespace telepalp::capture
