#include "proto/wire/mcap/format/stored_message.h"

#include <string>
#include <utility>

#include "codec/unmarked/unmarked_depth.h"

namespace telepalp::wire::mcap {
namespace {

/// Key and values of a channel's metadata.
constexpr const char* kFrames = "frames";
constexpr const char* kKey = "key";
constexpr const char* kPredicted = "predicted";

bool says_the_same(const Schema& a, const Schema& b) {
  return a.name == b.name && a.encoding == b.encoding && a.data == b.data;
}
bool says_the_same(const Channel& a, const Channel& b) {
  return a.schema_id == b.schema_id && a.topic == b.topic && a.message_encoding == b.message_encoding &&
         a.metadata == b.metadata;
}

std::optional<Topic> our_topic(const Channel& channel, const Schema* schema) {
  if (schema == nullptr || channel.message_encoding != "protobuf") return std::nullopt;
  const std::optional<Topic> topic = find_topic(channel.topic);
  return topic && topic->schema == schema->name ? topic : std::nullopt;
}

std::optional<bool> marked_key_frames(const Channel& channel) {
  const auto mark = channel.metadata.find(kFrames);
  if (mark == channel.metadata.end() || (mark->second != kKey && mark->second != kPredicted)) return std::nullopt;
  return mark->second == kKey;
}

StoredChannel described(Channel channel, const Schema* schema) {
  const std::optional<Topic> topic = our_topic(channel, schema);
  const std::optional<bool> marked = marked_key_frames(channel);
  const bool is_never_predicted = topic && !topic->predicted;
  return {std::move(channel), schema, topic, is_never_predicted ? std::optional(true) : marked};
}

}  // namespace

bool ChannelTable::add(Schema schema) {
  if (schema.id == 0) return false;
  const auto [place, added] = schemas_.try_emplace(schema.id, schema);
  return added || says_the_same(place->second, schema);
}

bool ChannelTable::add(Channel channel) {
  const auto schema = schemas_.find(channel.schema_id);
  if (channel.schema_id != 0 && schema == schemas_.end()) return false;
  const Schema* const type = channel.schema_id == 0 ? nullptr : &schema->second;
  const auto [place, added] = channels_.try_emplace(channel.id, described(channel, type));
  return added || says_the_same(place->second.channel, channel);
}

const StoredChannel* ChannelTable::find(std::uint16_t channel_id) const noexcept {
  const auto place = channels_.find(channel_id);
  return place == channels_.end() ? nullptr : &place->second;
}

Channel channel_for(const Topic& topic, KeyFrame key_frame) {
  Channel channel{
      .id = 0, .schema_id = 0, .topic = std::string(topic.name), .message_encoding = "protobuf", .metadata = {}};
  if (topic.predicted) channel.metadata[kFrames] = key_frame ? kKey : kPredicted;
  return channel;
}

bool is_key_frame(const StoredMessage& stored) {
  if (stored.channel->key_frames || !stored.channel->topic) return stored.channel->key_frames.value_or(true);
  return codec::is_unmarked_key_frame(stored.record.data);
}

Channel marked_channel(const StoredMessage& stored) {
  Channel channel = stored.channel->channel;
  if (stored.channel->topic && !stored.channel->key_frames)
    channel.metadata[kFrames] = is_key_frame(stored) ? kKey : kPredicted;
  return channel;
}

std::optional<Message> to_message(const StoredMessage& stored) {
  const MessageRecord& record = stored.record;
  if (!stored.channel->topic || record.data.size() > kMaxPayloadBytes || record.publish_time > INT64_MAX)
    return std::nullopt;
  return Message{*stored.channel->topic, session_time(static_cast<std::int64_t>(record.publish_time)),
                 std::make_shared<const std::string>(record.data), record.sequence, is_key_frame(stored)};
}

}  // namespace telepalp::wire::mcap
