#pragma once

#include <optional>

#include "proto/wire/message.h"
#include "server/playback/time_map.h"

namespace telepalp::playback {

/// Added to the sender numbers of recorded stations, so that a live station never has the same number.
inline constexpr std::uint32_t kRecordedSenders = 1000;

/// `recorded` as a message of now: each instant in it (a field NAME_ns of type fixed64 that is not 0, or a Timestamp)
/// is mapped by `map`. Everything else is kept, compressed images to the byte. `key_frame` is set. nullopt: the payload
/// is not of its topic's type.
[[nodiscard]] std::optional<wire::Message> retimed(const wire::Message& recorded, const TimeMap& map);

}  // namespace telepalp::playback
