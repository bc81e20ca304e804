#include "proto/wire/connection/incoming_channels.h"

#include <algorithm>
#include <string>
#include <utility>

#include "codec/unmarked/unmarked_depth.h"
#include "proto/wire/connection/bad_peer.h"

namespace telepalp::wire {
namespace {

constexpr std::size_t kMaxChannels = 256;

Error no_publisher(const Topic& topic) {
  return {.what = "this client may not publish " + std::string(topic.name),
          .where = {},
          .fix = "publish only topics that begin with /station/, from a station that holds the touch"};
}

/// A frame of a version that does not mark predicted messages is decided by its payload.
bool is_key_frame(const Topic& topic, const Frame& frame) {
  if (!topic.predicted) return true;
  if (frame.header.version >= kFirstVersionThatMarks) return !frame.header.predicted;
  return codec::is_unmarked_key_frame(frame.payload);
}

}  // namespace

Result<void> IncomingChannels::advertise(const msg::Advertise& advertise,
                                         const std::function<bool(const Topic&)>& accepts) {
  for (const msg::Advertise::Topic& entry : advertise.topics()) {
    const std::optional<Topic> topic = find_topic(entry.name());
    if (topic && topic->schema != entry.schema())
      return bad_peer("advertises " + std::string(topic->name) + " with another message type than " +
                      std::string(topic->schema));
    if (topic && !accepts(*topic)) return no_publisher(*topic);
    if (channels_.size() >= kMaxChannels) return bad_peer("advertises more than 256 channels");
    if (entry.channel() == 0) return bad_peer("announces a topic on channel 0, which is reserved for control messages");
    if (!channels_.try_emplace(entry.channel(), Channel{topic, 0}).second)
      return bad_peer("advertises channel " + std::to_string(entry.channel()) + " twice");
  }
  return {};
}

Result<std::optional<Message>> IncomingChannels::take(Frame frame) {
  const auto found = channels_.find(frame.header.channel);
  if (found == channels_.end())
    return bad_peer("sends on channel " + std::to_string(frame.header.channel) + " without advertising it");
  Channel& channel = found->second;
  if (!channel.topic) return std::optional<Message>{};
  if (frame.header.predicted && !channel.topic->predicted)
    return bad_peer("sends a predicted message of " + std::string(channel.topic->name) +
                    ", a topic without predicted messages");
  const bool key_frame = is_key_frame(*channel.topic, frame);
  return counted(channel,
                 {*channel.topic, frame.header.published, std::make_shared<const std::string>(std::move(frame.payload)),
                  frame.header.sequence, key_frame});
}

std::optional<Message> IncomingChannels::take_datagram(Message message) {
  const auto found = std::ranges::find_if(channels_, [&](const auto& entry) {
    return entry.second.topic && entry.second.topic->name == message.topic.name;
  });
  if (found == channels_.end()) return std::nullopt;
  found->second.by_datagram = true;
  return counted(found->second, std::move(message));
}

std::optional<Message> IncomingChannels::counted(Channel& channel, Message message) {
  const std::uint64_t sequence = message.sequence;
  if (channel.by_datagram && sequence <= channel.last_sequence)
    return std::nullopt;  // it was counted as missed when it was overtaken
  ReceivedCount& count = received_[channel.topic->name];
  ++count.messages;
  if (channel.last_sequence != 0 && sequence > channel.last_sequence)
    count.missed += sequence - channel.last_sequence - 1;
  channel.last_sequence = sequence;
  return message;
}

void IncomingChannels::forget_sequences() noexcept {
  for (auto& [number, channel] : channels_) channel.last_sequence = 0;
}

}  // namespace telepalp::wire
