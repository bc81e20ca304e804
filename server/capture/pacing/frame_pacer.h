#pragma once

#include <cstdint>
#include <optional>

#include "proto/wire/session_clock.h"

namespace telepalp::capture {

/// The time slot of one frame.
struct FrameSlot {
  std::uint64_t index = 0;  ///< number of periods since the first frame
  SessionTime due;          ///< when the frame is due
};

/// Paces the frames of a source without a camera. Slot 0 is due at the first next(), slot k is due k periods after slot
/// 0, so delays do not accumulate. Like a camera, the pacer drops a slot that was not fetched before the next is due.
class FramePacer {
 public:
  /// `paced` false: next() does not wait, and no slot is dropped.
  FramePacer(wire::SessionClock clock, Nanoseconds period, bool paced) noexcept;

  /// Sleeps until the next slot is due, at most `patience`; nullopt: the slot is due later than that.
  [[nodiscard]] std::optional<FrameSlot> next(Nanoseconds patience);

 private:
  wire::SessionClock clock_;
  Nanoseconds period_;
  bool paced_;
  std::optional<SessionTime> start_;
  std::uint64_t next_index_ = 0;
};

}  // namespace telepalp::capture
