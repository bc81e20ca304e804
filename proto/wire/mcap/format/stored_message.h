#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include "proto/wire/mcap/format/records.h"
#include "proto/wire/message.h"

namespace telepalp::wire::mcap {

/// A channel with its schema, as a file holds them.
struct StoredChannel {
  Channel channel;
  const Schema* schema = nullptr;  ///< null: the channel has none
  std::optional<Topic> topic;      ///< set if it is one of telepalp's, with the same type
};

/// The channels and schemas of a file, by id. Addresses of what it holds do not change.
class ChannelTable {
 public:
  /// False if the record may not stand in a file: a schema id of 0, a schema that is not there, an id that already
  /// means something else.
  [[nodiscard]] bool add(Schema schema);
  [[nodiscard]] bool add(Channel channel);

  [[nodiscard]] const StoredChannel* find(std::uint16_t channel_id) const noexcept;
  [[nodiscard]] const std::map<std::uint16_t, StoredChannel>& all() const noexcept { return channels_; }

 private:
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, StoredChannel> channels_;
};

/// One message of a file. Valid until the reader that gave it is asked for the next.
struct StoredMessage {
  const StoredChannel* channel = nullptr;
  MessageRecord record;
};

/// The message as it was published; nullopt if its topic is not one of ours, it is too large for the wire, or its
/// time is beyond the year 2262.
[[nodiscard]] std::optional<Message> to_message(const StoredMessage& stored);

}  // namespace telepalp::wire::mcap
