#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "proto/wire/message.h"
#include "proto/wire/urgent.h"

namespace telepalp::wire {

/// The queue of messages to one peer. It is bounded by topic (Topic::backlog), in messages and bytes: at a topic's
/// limit its own oldest messages are dropped, so a large topic cannot displace a small one. A message of a topic that
/// has no queued message is always accepted. It is the only message queue between publisher and socket.
class SendQueue {
 public:
  /// Adds `message` and returns the dropped messages: as many of the topic's oldest messages as needed, each with the
  /// messages predicted from it. If `message` itself is predicted from a queued message and there is no room, `message`
  /// is dropped, because dropping older ones would remove its reference.
  std::vector<Message> push(const Message& message);

  /// While `on`, datagrams carry the topics with a deadline (Topic::datagram_channel): pop() skips their messages, and
  /// pop_newest() takes them. Call it while no message of these topics is queued.
  void send_by_datagram(bool on) noexcept { by_datagram_ = on; }

  /// The next message to send. Messages of Lane::First go first, oldest first. The other topics, oldest first, get a
  /// quarter of their bytes while both wait, so that neither stops the other.
  std::optional<Message> pop();

  /// The next message to send by datagram, of those wanted. Speech goes first, then the other urgent topics, because
  /// they are small and must not wait for a picture. Of several, the one whose message has waited longest comes next.
  /// The message is the newest key frame of its topic, or the oldest message if no key frame is queued. Older messages
  /// of the topic go to `gone`.
  std::optional<Message> pop_newest(std::vector<Message>& gone, Wanted wanted = Wanted::Any);

  /// Of the topics of Lane::Others that wait for TCP, finds the one with the most queued bytes and removes its
  /// oldest message.
  std::optional<Message> drop_of_largest();

  [[nodiscard]] std::size_t waiting(const Topic& topic) const;
  [[nodiscard]] bool empty() const noexcept { return size() == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return datagrams_.size() + first_.size() + others_.size(); }
  /// Queued bytes of the topics of Lane::Others that wait for TCP.
  [[nodiscard]] std::size_t other_bytes() const noexcept { return other_bytes_; }

  /// Removes all messages for which `matches` is true; returns their number.
  template <class Matches>
  std::size_t remove_if(Matches matches) {
    const auto remove = [&](const Message& message) {
      if (!matches(message)) return false;
      count_out(message);
      return true;
    };
    return std::erase_if(datagrams_, remove) + std::erase_if(first_, remove) + std::erase_if(others_, remove);
  }

 private:
  struct Waiting {
    std::size_t messages = 0;
    std::size_t bytes = 0;
  };
  using Queue = std::deque<Message>;
  [[nodiscard]] Queue::const_iterator next_datagram(Wanted wanted) const;

  Queue& queue_of(const Topic& topic) noexcept;
  [[nodiscard]] bool goes_by_datagram(const Topic& topic) const noexcept {
    return by_datagram_ && topic.has_deadline();
  }
  [[nodiscard]] bool has_room(const Message& message) const;
  Message take(Queue& queue, Queue::iterator at);
  void take_oldest(const Message& to_make_room_for, std::vector<Message>& gone);
  void count_in(const Message& message);
  void count_out(const Message& message);

  Queue datagrams_;                              // topics with a deadline while by_datagram_ is true
  Queue first_;                                  // Lane::First
  Queue others_;                                 // Lane::Others
  std::map<std::string_view, Waiting> waiting_;  // key: topic
  bool by_datagram_ = false;
  std::size_t other_bytes_ = 0;
  std::size_t others_credit_bytes_ = 0;  // bytes that others_ may send, earned by bytes sent from first_
};

}  // namespace telepalp::wire
