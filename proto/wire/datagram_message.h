#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "proto/link/datagram_link.h"
#include "proto/wire/message.h"

namespace telepalp::wire {

/// A message of a topic with a deadline (Topic::datagram_channel) as a frame of datagrams: 8 bytes published_ns, 8
/// bytes sequence, little-endian, and the payload. The frame's deadline counts from the publication, or from `now` if
/// the publication is in the future or a second or more ago: a stamp in the future would make the frame never late, and
/// an old one late at once.
/// Shares the payload of `message`.
[[nodiscard]] std::shared_ptr<const link::SharedFrame> frame_of(const Message& message, SessionTime now);

/// Makes each message's frame once, however many peers it is sent to, so that they share its repair shards.
class FrameCache {
 public:
  /// frame_of(), or the same frame as before while a peer still keeps it.
  [[nodiscard]] std::shared_ptr<const link::SharedFrame> frame_of(const Message& message, SessionTime now);

 private:
  struct Made {
    std::weak_ptr<const link::SharedFrame> frame;
    const std::string* payload;  // unique while the frame lives, which keeps it
    std::uint64_t sequence;
  };
  static constexpr std::size_t kMost = 16;  // a few messages of each topic
  std::deque<Made> made_;                   // oldest first
};

/// The message that frame_of() packed into `frame`; nullopt: no topic has its channel, it is shorter than 16 bytes, or
/// it is predicted although its topic has no predicted messages.
[[nodiscard]] std::optional<Message> message_of(const link::Frame& frame);

}  // namespace telepalp::wire
