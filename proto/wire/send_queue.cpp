#include "proto/wire/send_queue.h"

#include <algorithm>

#include "proto/wire/topics.h"

namespace telepalp::wire {

std::size_t queue_limit(std::string_view topic) noexcept {
  constexpr std::size_t kImages = 2;   // beside the one being sent: one about to go, one newest
  constexpr std::size_t kSmall = 256;  // 2.5 s of the 100 Hz topics
  return topic == kCameraColor.name || topic == kCameraDepth.name ? kImages : kSmall;
}

std::size_t SendQueue::waiting(const Topic& topic) const {
  return static_cast<std::size_t>(std::count_if(
      waiting_.begin(), waiting_.end(), [&](const Message& message) { return message.topic.name == topic.name; }));
}

std::vector<Message> SendQueue::push(const Message& message) {
  const auto same_topic = [&](const Message& other) { return other.topic.name == message.topic.name; };
  std::vector<Message> gone;
  if (waiting(message.topic) >= queue_limit(message.topic.name)) {
    if (!message.stands_alone) return {message};
    auto oldest = std::find_if(waiting_.begin(), waiting_.end(), same_topic);
    do {
      gone.push_back(std::move(*oldest));
      oldest = std::find_if(waiting_.erase(oldest), waiting_.end(), same_topic);
    } while (oldest != waiting_.end() && !oldest->stands_alone);
  }
  waiting_.push_back(message);
  return gone;
}

std::optional<Message> SendQueue::pop() {
  if (waiting_.empty()) return std::nullopt;
  Message message = std::move(waiting_.front());
  waiting_.pop_front();
  return message;
}

}  // namespace telepalp::wire
