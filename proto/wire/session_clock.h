#pragma once

#include "proto/words/time.h"

namespace telepalp::wire {

/// The session's clock, read at the edge and never inside pure code. Monotone: the steady clock, shifted so that
/// the server's start reads as its wall-clock time; a wall clock that jumps later changes nothing.
/// A client's copy is the server's clock plus the offset that ClockSync estimates.
class SessionClock {
 public:
  /// A clock for the server: anchored to the wall clock now.
  [[nodiscard]] static SessionClock anchored_to_wall_clock();

  /// A clock for a client: `offset` is session time minus this machine's steady clock.
  explicit SessionClock(Nanoseconds offset) noexcept : offset_(offset) {}

  [[nodiscard]] SessionTime now() const noexcept;
  [[nodiscard]] Nanoseconds offset() const noexcept { return offset_; }

  /// The instant of this machine's steady clock at which the session clock reads `at`.
  [[nodiscard]] std::chrono::steady_clock::time_point steady(SessionTime at) const noexcept;

 private:
  Nanoseconds offset_;
};

}  // namespace telepalp::wire
