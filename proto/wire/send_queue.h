#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "proto/wire/message.h"

namespace telepalp::wire {

/// How much of one topic may wait for one peer. A single message may wait whatever its size.
struct QueueLimit {
  std::size_t messages;
  std::size_t bytes;
};

/// Images are worth only their newest; small topics are worth a short history.
[[nodiscard]] QueueLimit queue_limit(std::string_view topic) noexcept;

/// What waits to be sent to one peer. Bounded by topic, in messages and bytes: a large topic that backs up loses its
/// own oldest messages and cannot push out a small one. It is the only queue of messages between publisher and socket.
class SendQueue {
 public:
  /// Adds `message` and returns the dropped messages: the topic's oldest one with the messages predicted from it. If
  /// `message` itself is predicted from a queued message and there is no room, `message` is dropped, because dropping
  /// older ones would remove its reference.
  std::vector<Message> push(const Message& message);

  /// The next message to send. Messages of /camera/... go first, oldest first. The other topics, oldest first, get a
  /// quarter of the camera's bytes while both wait, so that neither stops the other.
  std::optional<Message> pop();

  /// Takes out the oldest message of the topic outside /camera/... that has the most bytes here.
  std::optional<Message> drop_of_largest();

  [[nodiscard]] std::size_t waiting(const Topic& topic) const;
  [[nodiscard]] bool empty() const noexcept { return camera_.empty() && others_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return camera_.size() + others_.size(); }
  /// Bytes of the topics outside /camera/...: what peers publish is among them.
  [[nodiscard]] std::size_t other_bytes() const noexcept { return other_bytes_; }

  /// Removes all messages for which `matches` is true; returns their number.
  template <class Matches>
  std::size_t remove_if(Matches matches) {
    const auto remove = [&](const Message& message) {
      if (!matches(message)) return false;
      count_out(message);
      return true;
    };
    return std::erase_if(camera_, remove) + std::erase_if(others_, remove);
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

  Lane camera_;
  Lane others_;
  std::map<std::string_view, Waiting> waiting_;  // by topic
  std::size_t other_bytes_ = 0;
  std::size_t others_credit_bytes_ = 0;  // of others_, from what the camera was given
};

}  // namespace telepalp::wire
