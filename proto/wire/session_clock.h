#pragma once

#include "proto/words/time.h"

namespace telepalp::wire {

/// The session clock; pure code never reads it. It is monotonic: the server's steady clock plus an offset, so that it
/// equals the wall clock at the server's start; later jumps of the wall clock have no effect. A client uses its own
/// steady clock plus the offset that ClockSync estimates.
class SessionClock {
 public:
  /// The wall clock at this call, continued by the steady clock: the server's clock, or a client's before it connects.
  [[nodiscard]] static SessionClock anchored_to_wall_clock();

  /// A client's clock. `offset` is session time minus this machine's steady clock.
  explicit SessionClock(Nanoseconds offset) noexcept : offset_(offset) {}

  [[nodiscard]] SessionTime now() const noexcept;
  [[nodiscard]] Nanoseconds offset() const noexcept { return offset_; }

  /// The instant of this machine's steady clock at which the session clock reads `at`.
  [[nodiscard]] std::chrono::steady_clock::time_point steady(SessionTime at) const noexcept;

 private:
  Nanoseconds offset_;
};

}  // namespace telepalp::wire
