#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include "proto/wire/mcap/format/records.h"
#include "proto/wire/message.h"

namespace telepalp::wire::mcap {

/// A channel of a file with its schema.
struct StoredChannel {
  Channel channel;
  const Schema* schema = nullptr;  ///< null: the channel has none
  std::optional<Topic> topic;      ///< set if name and type match one of telepalp's topics
  /// True: all messages of the channel are key frames. False: all are predicted. nullopt: the channel does not say it.
  std::optional<bool> key_frames;
};

/// The channel of a file for the messages of `topic`; its ids are 0. A topic with predicted messages has two channels,
/// one for its key frames and one for the others, so that the message index of the first is an index of key frames.
[[nodiscard]] Channel channel_for(const Topic& topic, KeyFrame key_frame);

/// The channels and schemas of a file, by id. References to its entries stay valid.
class ChannelTable {
 public:
  /// False if the record is invalid: a schema id of 0, a reference to an unknown schema, or an id that is already used
  /// for a different record.
  [[nodiscard]] bool add(Schema schema);
  [[nodiscard]] bool add(Channel channel);

  /// True if the schema `id` was added, and for the id 0, which means "no schema".
  [[nodiscard]] bool has_schema(std::uint16_t id) const noexcept { return id == 0 || schemas_.contains(id); }
  [[nodiscard]] const StoredChannel* find(std::uint16_t channel_id) const noexcept;
  [[nodiscard]] const std::map<std::uint16_t, StoredChannel>& all() const noexcept { return channels_; }

 private:
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, StoredChannel> channels_;
};

/// One message of a file. Valid until the next call of the reader that returned it.
struct StoredMessage {
  const StoredChannel* channel = nullptr;
  MessageRecord record;
};

/// Whether the message is a key frame: its channel says it. In a file of an earlier release, where the channel does
/// not, its payload decides.
[[nodiscard]] bool is_key_frame(const StoredMessage& stored);

/// The channel of `stored` with a mark of key frames, for a copy: that of a file of an earlier release has none.
[[nodiscard]] Channel marked_channel(const StoredMessage& stored);

/// Converts to the message that was published on the wire; nullopt if its topic is not one of telepalp's, its payload
/// exceeds kMaxPayloadBytes, or its publish time is after the year 2262 (the end of 64-bit nanoseconds).
[[nodiscard]] std::optional<Message> to_message(const StoredMessage& stored);

}  // namespace telepalp::wire::mcap
