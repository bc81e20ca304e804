#include "proto/wire/datagram_message.h"

#include <cstring>

#include "proto/words/demand.h"
#include "proto/words/little_endian.h"

namespace telepalp::wire {
namespace {

constexpr std::size_t kLabelBytes = 16;

}  // namespace

link::Frame frame_of(const Message& message, SessionTime now) {
  const std::optional<std::uint8_t> channel = message.topic.datagram_channel;
  demand(channel.has_value(), "only topics with a deadline travel by datagram");
  const bool fresh = message.published <= now && now - message.published < std::chrono::seconds(1);
  link::Frame frame{.channel = *channel,
                    .number = static_cast<std::uint32_t>(message.sequence),
                    .key_frame = message.key_frame,
                    .captured = fresh ? message.published : now,
                    .bytes = std::vector<std::byte>(kLabelBytes + message.payload->size())};
  put_little_endian<std::int64_t>(frame.bytes.data(), to_nanoseconds(message.published));
  put_little_endian<std::uint64_t>(frame.bytes.data() + 8, message.sequence);
  std::memcpy(frame.bytes.data() + kLabelBytes, message.payload->data(), message.payload->size());
  return frame;
}

std::optional<Message> message_of(const link::Frame& frame) {
  const std::optional<Topic> topic = topic_of_datagram_channel(frame.channel);
  if (!topic || frame.bytes.size() < kLabelBytes || (!frame.key_frame && !topic->predicted)) return std::nullopt;
  const auto* const payload = reinterpret_cast<const char*>(frame.bytes.data() + kLabelBytes);
  return Message{.topic = *topic,
                 .published = session_time(get_little_endian<std::int64_t>(frame.bytes.data())),
                 .payload = std::make_shared<const std::string>(payload, frame.bytes.size() - kLabelBytes),
                 .sequence = get_little_endian<std::uint64_t>(frame.bytes.data() + 8),
                 .key_frame = frame.key_frame};
}

}  // namespace telepalp::wire
