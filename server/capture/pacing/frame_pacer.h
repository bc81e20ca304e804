#pragma once

#include <cstdint>
#include <optional>

#include "proto/wire/session_clock.h"

namespace telepalp::server {

/// One frame's place in time.
struct FrameSlot {
  std::uint64_t index = 0;  ///< counts periods since the first frame
  SessionTime due;          ///< the instant it stands for
};

/// Gives the frames of a source without a sensor their pace. Slot 0 is due when first asked for, slot k exactly k
/// periods later, so that no delay ever adds up. As a camera does, it drops the frames that nobody fetched in time.
class FramePacer {
 public:
  /// `paced` false: every slot is given at once, and none is dropped.
  FramePacer(wire::SessionClock clock, Nanoseconds period, bool paced) noexcept;

  /// Sleeps until the next slot is due, at most `patience`; nullopt when it is not due by then.
  [[nodiscard]] std::optional<FrameSlot> next(Nanoseconds patience);

 private:
  wire::SessionClock clock_;
  Nanoseconds period_;
  bool paced_;
  std::optional<SessionTime> start_;
  std::uint64_t next_index_ = 0;
};

}  // namespace telepalp::server
