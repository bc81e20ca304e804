#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string_view>

#include "messages/control.pb.h"
#include "proto/wire/frame.h"
#include "proto/wire/message.h"

namespace telepalp::wire {

/// Received messages of one topic.
struct ReceivedCount {
  std::uint64_t messages = 0;
  std::uint64_t missed = 0;  ///< gaps in the sequence numbers: messages dropped, lost, or overtaken by a newer one
};

/// The reading side of one connection: the topics that the peer advertises, and which of their messages came. No socket
/// and no clock.
class IncomingChannels {
 public:
  /// `accepts`: true if this peer may publish the topic. Error: a topic that it may not publish, another message type
  /// than the topic's, a channel that is in use or reserved, or too many channels.
  [[nodiscard]] Result<void> advertise(const msg::Advertise& advertise,
                                       const std::function<bool(const Topic&)>& accepts);

  /// The message of a data frame; nullopt: it is of a topic that this end does not know, or a newer one came before by
  /// datagram. Error: nobody advertised its channel, or a predicted message of a topic without such.
  [[nodiscard]] Result<std::optional<Message>> take(Frame frame);
  /// A message that came by datagram; nullopt: its topic was not advertised, or a newer one came before.
  [[nodiscard]] std::optional<Message> take_datagram(Message message);

  /// This end subscribes again: messages from before do not count as missed.
  void forget_sequences() noexcept;

  [[nodiscard]] const std::map<std::string_view, ReceivedCount>& received() const noexcept { return received_; }

 private:
  struct Channel {
    std::optional<Topic> topic;  ///< nullopt: an unknown topic, whose messages are ignored
    std::uint64_t last_sequence = 0;
    bool by_datagram = false;  ///< true once a message came by datagram: then messages may overtake each other
  };
  [[nodiscard]] std::optional<Message> counted(Channel& channel, Message message);

  std::map<std::uint32_t, Channel> channels_;
  std::map<std::string_view, ReceivedCount> received_;
};

}  // namespace telepalp::wire
