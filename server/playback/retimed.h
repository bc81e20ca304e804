#pragma once

#include <cmath>
#include <optional>

#include "proto/wire/message.h"
#include "proto/words/time.h"

namespace telepalp::playback {

/// Maps instants of a recording to the session time at which they are played. The map is affine: all durations, such
/// as ages, are divided by `speed`. At speed 1 they are exact to the nanosecond.
struct TimeMap {
  SessionTime recorded{};  ///< this instant of the recording …
  SessionTime now{};       ///< … is played at this one
  double speed = 1.0;

  [[nodiscard]] SessionTime operator()(SessionTime at) const noexcept {
    const Nanoseconds since = at - recorded;
    if (speed == 1.0) return now + since;
    return now + Nanoseconds(std::llround(static_cast<double>(since.count()) / speed));
  }
};

/// Added to the sender numbers of recorded stations, so that they differ from those of connected stations.
inline constexpr std::uint32_t kRecordedSenders = 1000;

/// `recorded` with each instant in it (a field NAME_ns of type fixed64 that is not 0, or a Timestamp) mapped by `map`.
/// kRecordedSenders is added to a sender's number. All other content is kept, compressed images to the byte. In the
/// result, `key_frame` of a depth message is false for a predicted frame. nullopt: the payload is not of its topic's
/// type.
[[nodiscard]] std::optional<wire::Message> retimed(const wire::Message& recorded, const TimeMap& map);

}  // namespace telepalp::playback
