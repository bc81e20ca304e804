#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string_view>

#include "proto/wire/message.h"

namespace telepalp::server {

/// What waits to be sent to one subscriber, oldest first. Bounded by topic: a large topic that backs up loses its
/// own oldest messages and cannot push out a small one.
class SubscriberQueue {
 public:
  /// Adds `message`. Returns what had to go to make room, if anything did.
  std::optional<wire::Message> push(const wire::Message& message);
  std::optional<wire::Message> pop();
  [[nodiscard]] bool empty() const noexcept { return waiting_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return waiting_.size(); }
  void clear() noexcept { waiting_.clear(); }

 private:
  std::deque<wire::Message> waiting_;
};

/// How many messages of a topic may wait for one subscriber: images are worth only their newest, small topics are
/// worth a short history.
[[nodiscard]] std::size_t queue_limit(std::string_view topic) noexcept;

}  // namespace telepalp::server
