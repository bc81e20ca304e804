#include "proto/wire/mcap/format/stored_message.h"

#include <string>

namespace telepalp::wire::mcap {
namespace {

bool says_the_same(const Schema& a, const Schema& b) {
  return a.name == b.name && a.encoding == b.encoding && a.data == b.data;
}
bool says_the_same(const Channel& a, const Channel& b) {
  return a.schema_id == b.schema_id && a.topic == b.topic && a.message_encoding == b.message_encoding;
}

std::optional<Topic> our_topic(const Channel& channel, const Schema* schema) {
  if (schema == nullptr || channel.message_encoding != "protobuf") return std::nullopt;
  const std::optional<Topic> topic = find_topic(channel.topic);
  return topic && topic->schema == schema->name ? topic : std::nullopt;
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
  const auto [place, added] = channels_.try_emplace(channel.id, StoredChannel{channel, type, our_topic(channel, type)});
  return added || says_the_same(place->second.channel, channel);
}

const StoredChannel* ChannelTable::find(std::uint16_t channel_id) const noexcept {
  const auto place = channels_.find(channel_id);
  return place == channels_.end() ? nullptr : &place->second;
}

std::optional<Message> to_message(const StoredMessage& stored) {
  const MessageRecord& record = stored.record;
  if (!stored.channel->topic || record.data.size() > kMaxPayloadBytes || record.publish_time > INT64_MAX)
    return std::nullopt;
  return Message{*stored.channel->topic, session_time(static_cast<std::int64_t>(record.publish_time)),
                 std::make_shared<const std::string>(record.data), record.sequence};
}

}  // namespace telepalp::wire::mcap
