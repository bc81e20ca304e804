#pragma once

#include <optional>

#include "proto/link/datagram_link.h"
#include "proto/wire/message.h"

namespace telepalp::wire {

/// A message of a topic with a deadline (Topic::datagram_channel) as a frame of datagrams: 8 bytes published_ns, 8
/// bytes sequence, little-endian, and the payload. The frame's deadline counts from the publication, or from `now` if
/// the publication is in the future or a second or more ago: a stamp in the future would make the frame never late, and
/// an old one late at once.
[[nodiscard]] link::Frame frame_of(const Message& message, SessionTime now);

/// The message that frame_of() packed into `frame`; nullopt: no topic has its channel, it is shorter than 16 bytes, or
/// it is predicted although its topic has no predicted messages.
[[nodiscard]] std::optional<Message> message_of(const link::Frame& frame);

}  // namespace telepalp::wire
