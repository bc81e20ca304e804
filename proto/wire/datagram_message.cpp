#include "proto/wire/datagram_message.h"

#include <algorithm>
#include <array>
#include <span>

#include "proto/wire/urgent.h"
#include "proto/words/demand.h"
#include "proto/words/little_endian.h"

namespace telepalp::wire {
namespace {

constexpr std::size_t kLabelBytes = 16;

/// The time from which the frame's deadline counts.
SessionTime deadline_from(const Message& message, SessionTime now) {
  const bool fresh = message.published <= now && now - message.published < std::chrono::seconds(1);
  return fresh ? message.published : now;
}

}  // namespace

std::shared_ptr<const link::SharedFrame> frame_of(const Message& message, SessionTime now) {
  const std::optional<std::uint8_t> channel = message.topic.datagram_channel;
  demand(channel.has_value(), "only topics with a deadline travel by datagram");
  std::array<std::byte, kLabelBytes> label{};
  put_little_endian<std::int64_t>(label.data(), to_nanoseconds(message.published));
  put_little_endian<std::uint64_t>(label.data() + 8, message.sequence);
  return std::make_shared<const link::SharedFrame>(
      link::SharedFrame::Label{.channel = *channel,
                               .number = static_cast<std::uint32_t>(message.sequence),
                               .key_frame = message.key_frame,
                               .captured = deadline_from(message, now),
                               .echoed = message.topic.spoken,
                               .urgent = is_urgent(message.topic)},
      label, std::as_bytes(std::span(*message.payload)), message.payload);
}

std::shared_ptr<const link::SharedFrame> FrameCache::frame_of(const Message& message, SessionTime now) {
  std::erase_if(made_, [](const Made& made) { return made.frame.expired(); });
  for (const Made& made : made_) {
    if (made.payload != message.payload.get() || made.sequence != message.sequence) continue;
    std::shared_ptr<const link::SharedFrame> frame = made.frame.lock();
    if (frame->label().captured == deadline_from(message, now)) return frame;
  }
  std::shared_ptr<const link::SharedFrame> frame = wire::frame_of(message, now);
  made_.push_back({frame, message.payload.get(), message.sequence});
  if (made_.size() > kMost) made_.pop_front();
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
