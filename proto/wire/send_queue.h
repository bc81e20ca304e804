#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "proto/wire/message.h"

namespace telepalp::wire {

/// Limits of one topic's queue to one peer. One message is always accepted, whatever its size.
struct QueueLimit {
  std::size_t messages;
  std::size_t bytes;
};

/// The limits of a topic. Of images only the newest are useful; small topics keep a short history.
[[nodiscard]] QueueLimit queue_limit(std::string_view topic) noexcept;

/// The queue of messages to one peer. It is bounded by topic, in messages and bytes: at a topic's limit its own oldest
/// messages are dropped, so a large topic cannot displace a small one. It is the only message queue between publisher
/// and socket.
class SendQueue {
 public:
  /// Adds `message` and returns the dropped messages: the topic's oldest one with the messages predicted from it. If
  /// `message` itself is predicted from a queued message and there is no room, `message` is dropped, because dropping
  /// older ones would remove its reference.
  std::vector<Message> push(const Message& message);

  /// While `on`, pop() skips the deadline topics, because datagrams carry them: pop_newest() takes their messages. Call
  /// it while no such message waits.
  void send_by_datagram(bool on) noexcept { by_datagram_ = on; }

  /// The next message to send. Messages of /camera/... go first, oldest first. The other topics, oldest first, get a
  /// quarter of the camera's bytes while both wait, so that neither stops the other.
  std::optional<Message> pop();

  /// The next message to send by datagram: of one deadline topic, the newest that can be decoded without an older one
  /// that waits. Older messages of its topic go to `gone`. Topics take turns.
  std::optional<Message> pop_newest(std::vector<Message>& gone);

  /// Removes the oldest message of that topic outside /camera/... that occupies the most bytes in the queue.
  std::optional<Message> drop_of_largest();

  [[nodiscard]] std::size_t waiting(const Topic& topic) const;
  [[nodiscard]] bool empty() const noexcept { return size() == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return datagrams_.size() + camera_.size() + others_.size(); }
  /// Queued bytes of the topics outside /camera/... that wait for TCP.
  [[nodiscard]] std::size_t other_bytes() const noexcept { return other_bytes_; }

  /// Removes all messages for which `matches` is true; returns their number.
  template <class Matches>
  std::size_t remove_if(Matches matches) {
    const auto remove = [&](const Message& message) {
      if (!matches(message)) return false;
      count_out(message);
      return true;
    };
    return std::erase_if(datagrams_, remove) + std::erase_if(camera_, remove) + std::erase_if(others_, remove);
  }

 private:
  struct Waiting {
    std::size_t messages = 0;
    std::size_t bytes = 0;
  };
  using Lane = std::deque<Message>;

  Lane& lane_of(const Topic& topic) noexcept;
  [[nodiscard]] bool has_room(const Message& message) const;
  Message take(Lane& lane, Lane::iterator at);
  void take_oldest(const Message& to_make_room_for, std::vector<Message>& gone);
  void count_in(const Message& message);
  void count_out(const Message& message);

  Lane datagrams_;  // deadline topics while by_datagram_ is true
  Lane camera_;
  Lane others_;
  std::map<std::string_view, Waiting> waiting_;  // key: topic
  bool by_datagram_ = false;
  std::size_t other_bytes_ = 0;
  std::size_t others_credit_bytes_ = 0;  // bytes that others_ may send, earned by bytes sent from camera_
};

}  // namespace telepalp::wire
