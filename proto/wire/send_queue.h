#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string_view>
#include <vector>

#include "proto/wire/message.h"

namespace telepalp::wire {

/// What waits to be sent to one peer, oldest first. Bounded by topic: a large topic that backs up loses its own
/// oldest messages and cannot push out a small one. It is the only queue of messages between publisher and socket.
class SendQueue {
 public:
  /// Adds `message`. Returns what could not stay: the topic's oldest, with those that depend on it; or `message`
  /// itself, when it depends on one that waits and there is no room, for making room would take away what it depends
  /// on.
  std::vector<Message> push(const Message& message);
  std::optional<Message> pop();
  [[nodiscard]] std::size_t waiting(const Topic& topic) const;
  [[nodiscard]] bool empty() const noexcept { return waiting_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return waiting_.size(); }
  /// Takes out what `matches`; returns how many.
  template <class Matches>
  std::size_t remove_if(Matches matches) {
    return std::erase_if(waiting_, matches);
  }

 private:
  std::deque<Message> waiting_;
};

/// How many messages of a topic may wait for one peer: images are worth only their newest, small topics are
/// worth a short history.
[[nodiscard]] std::size_t queue_limit(std::string_view topic) noexcept;

}  // namespace telepalp::wire
