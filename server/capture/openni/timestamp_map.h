#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "proto/words/clock_envelope.h"
#include "proto/words/time.h"

namespace telepalp::capture {

/// Maps a driver's time stamps, of any epoch, to session time. The offset follows the least delayed arrivals
/// (ClockEnvelope). A driver clock that steps back, or leaps by more than 0.5 s against session time (a recording that
/// starts over, a device that resets), starts a new mapping. The results strictly increase.
class TimestampMap {
 public:
  /// The session time of a frame with the driver's stamp `driver` that arrived at `arrival`: at most `arrival`, but at
  /// least 1 ns after the previous result.
  [[nodiscard]] SessionTime map(std::chrono::microseconds driver, SessionTime arrival);

  /// Number of jumps of the driver's clock.
  [[nodiscard]] std::uint64_t jumps() const noexcept { return envelope_.jumps(); }

 private:
  ClockEnvelope envelope_;
  std::optional<std::chrono::microseconds> last_driver_;
  std::optional<SessionTime> last_;
};

}  // namespace telepalp::capture
