#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "proto/link/datagram_link.h"
#include "proto/wire/message.h"

namespace telepalp::wire {

/// Topics whose messages are worthless when they are late: images, and poses, of which the newest replaces all before.
/// The index of a topic is its datagram channel (WIRE.md).
inline constexpr std::array kDeadlineTopics{kCameraDepth, kCameraColor, kStationState, kViewerHand};

/// The datagram channel of `topic`; nullopt: its messages travel over TCP alone.
[[nodiscard]] constexpr std::optional<std::uint8_t> datagram_channel(const Topic& topic) noexcept {
  for (std::size_t i = 0; i < kDeadlineTopics.size(); ++i)
    if (kDeadlineTopics[i].name == topic.name) return static_cast<std::uint8_t>(i);
  return std::nullopt;
}

[[nodiscard]] constexpr bool has_deadline(const Topic& topic) noexcept { return datagram_channel(topic).has_value(); }

/// A message of a deadline topic as a frame of datagrams: 8 bytes published_ns, 8 bytes sequence, little-endian, and
/// the payload. The frame's deadline counts from the publication, or from `now` if the publication is in the future or
/// a second or more ago: a stamp in the future would make the frame never late, and an old one late at once.
[[nodiscard]] link::Frame frame_of(const Message& message, SessionTime now);

/// The message that frame_of() packed into `frame`; nullopt: no topic has its channel, or it is shorter than 16 bytes.
[[nodiscard]] std::optional<Message> message_of(const link::Frame& frame);

}  // namespace telepalp::wire
