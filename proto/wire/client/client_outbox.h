#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "proto/wire/message.h"
#include "proto/wire/send_queue.h"

namespace telepalp::wire {

/// The messages that a client publishes, until a socket takes them. No socket.
class ClientOutbox {
 public:
  /// Queues `message` with the topic's next number. False: without a connection it is dropped, unless its topic is one
  /// that is kept for the next one.
  bool put(Message message, bool connected) {
    message.sequence = ++sequences_[message.topic.name];
    if (!connected && !message.topic.kept_while_away) {
      ++not_sent_;
      return false;
    }
    not_sent_ += queue_.push(message).size();
    return true;
  }

  /// The next message for TCP.
  [[nodiscard]] std::optional<Message> next() { return counted(queue_.pop()); }
  /// The next message for a datagram, of those wanted: the newest of a topic with a deadline.
  [[nodiscard]] std::optional<Message> next_for_datagram(Wanted wanted) {
    std::vector<Message> replaced;
    std::optional<Message> message = queue_.pop_newest(replaced, wanted);
    not_sent_ += replaced.size();
    return counted(std::move(message));
  }

  /// From now on datagrams carry the topics with a deadline, or TCP does again. Messages of these topics that wait are
  /// dropped: newer ones follow.
  void send_by_datagram(bool on) {
    not_sent_ += queue_.remove_if([](const Message& message) { return message.topic.has_deadline(); });
    queue_.send_by_datagram(on);
  }
  /// The connection was lost: drops the messages that the next connection does not need.
  void connection_lost() {
    not_sent_ += queue_.remove_if([](const Message& message) { return !message.topic.kept_while_away; });
  }

  [[nodiscard]] std::uint64_t published() const noexcept { return published_; }  ///< passed to a socket
  [[nodiscard]] std::uint64_t not_sent() const noexcept { return not_sent_; }    ///< dropped

 private:
  std::optional<Message> counted(std::optional<Message> message) {
    if (message) ++published_;
    return message;
  }

  SendQueue queue_;
  std::map<std::string_view, std::uint64_t> sequences_;  // last number by topic
  std::uint64_t published_ = 0;
  std::uint64_t not_sent_ = 0;
};

}  // namespace telepalp::wire
