#include "proto/wire/send_queue.h"

#include <algorithm>
#include <utility>

namespace telepalp::wire {
namespace {

/// Limits of one topic's queue to one peer.
struct QueueLimit {
  std::size_t messages;
  std::size_t bytes;
};

QueueLimit queue_limit(const Topic& topic, bool by_datagram) noexcept {
  constexpr QueueLimit kNewest{.messages = 2, .bytes = 2 * kMaxPayloadBytes};  // one is sent next, the other is newest
  constexpr QueueLimit kHistory{.messages = 256, .bytes = std::size_t{1} << 20};  // 2.5 s of the 100 Hz topics
  return by_datagram || topic.backlog == Backlog::Newest ? kNewest : kHistory;
}

}  // namespace

SendQueue::Queue& SendQueue::queue_of(const Topic& topic) noexcept {
  if (goes_by_datagram(topic)) return datagrams_;
  return topic.lane == Lane::First ? first_ : others_;
}

std::size_t SendQueue::waiting(const Topic& topic) const {
  const auto found = waiting_.find(topic.name);
  return found == waiting_.end() ? 0 : found->second.messages;
}

void SendQueue::count_in(const Message& message) {
  Waiting& topic = waiting_[message.topic.name];
  ++topic.messages;
  topic.bytes += message.payload->size();
  if (&queue_of(message.topic) == &others_) other_bytes_ += message.payload->size();
}

void SendQueue::count_out(const Message& message) {
  Waiting& topic = waiting_[message.topic.name];
  --topic.messages;
  topic.bytes -= message.payload->size();
  if (&queue_of(message.topic) == &others_) other_bytes_ -= message.payload->size();
}

bool SendQueue::has_room(const Message& message) const {
  const auto found = waiting_.find(message.topic.name);
  if (found == waiting_.end() || found->second.messages == 0) return true;
  const QueueLimit limit = queue_limit(message.topic, goes_by_datagram(message.topic));
  return found->second.messages < limit.messages && found->second.bytes + message.payload->size() <= limit.bytes;
}

Message SendQueue::take(Queue& queue, Queue::iterator at) {
  Message message = std::move(*at);
  queue.erase(at);
  count_out(message);
  return message;
}

void SendQueue::take_oldest(const Message& to_make_room_for, std::vector<Message>& gone) {
  Queue& queue = queue_of(to_make_room_for.topic);
  const auto oldest = [&] {
    return std::find_if(queue.begin(), queue.end(),
                        [&](const Message& other) { return other.topic.name == to_make_room_for.topic.name; });
  };
  do gone.push_back(take(queue, oldest()));
  while (oldest() != queue.end() && !oldest()->key_frame);
}

std::vector<Message> SendQueue::push(const Message& message) {
  if (!has_room(message) && !message.key_frame) return {message};
  std::vector<Message> gone;
  while (!has_room(message)) take_oldest(message, gone);
  queue_of(message.topic).push_back(message);
  count_in(message);
  return gone;
}

std::optional<Message> SendQueue::pop() {
  if (first_.empty()) return others_.empty() ? std::nullopt : std::optional(take(others_, others_.begin()));
  if (!others_.empty() && others_.front().payload->size() <= others_credit_bytes_) {
    others_credit_bytes_ -= others_.front().payload->size();
    return take(others_, others_.begin());
  }
  constexpr std::size_t kMostCredit = kMaxPayloadBytes;  // enough for the largest message
  constexpr std::size_t kShare = 4;
  Message message = take(first_, first_.begin());
  others_credit_bytes_ = std::min(kMostCredit, others_credit_bytes_ + message.payload->size() / kShare);
  return message;
}

SendQueue::Queue::const_iterator SendQueue::next_datagram(Wanted wanted) const {
  const auto spoken = std::ranges::find_if(datagrams_, [](const Message& message) { return message.topic.spoken; });
  if (spoken != datagrams_.end()) return spoken;
  const auto urgent = std::ranges::find_if(datagrams_, [](const Message& one) { return is_urgent(one.topic); });
  return urgent == datagrams_.end() && wanted == Wanted::Any ? datagrams_.begin() : urgent;
}

std::optional<Message> SendQueue::pop_newest(std::vector<Message>& gone, Wanted wanted) {
  const auto next = next_datagram(wanted);
  if (next == datagrams_.end()) return std::nullopt;
  const std::string_view topic = next->topic.name;
  const auto is_key = [&](const Message& message) { return message.topic.name == topic && message.key_frame; };
  const auto of_topic = [&](const Message& message) { return message.topic.name == topic; };
  const auto newest_key = std::find_if(datagrams_.rbegin(), datagrams_.rend(), is_key);
  const std::uint64_t first = newest_key == datagrams_.rend() ? 0 : newest_key->sequence;
  const auto oldest = [&] { return std::find_if(datagrams_.begin(), datagrams_.end(), of_topic); };
  while (oldest()->sequence < first) gone.push_back(take(datagrams_, oldest()));
  return take(datagrams_, oldest());
}

std::optional<Message> SendQueue::drop_of_largest() {
  if (others_.empty()) return std::nullopt;
  std::string_view largest = others_.front().topic.name;
  for (const Message& message : others_)
    if (waiting_.at(message.topic.name).bytes > waiting_.at(largest).bytes) largest = message.topic.name;
  return take(others_, std::find_if(others_.begin(), others_.end(),
                                    [&](const Message& message) { return message.topic.name == largest; }));
}

}  // namespace telepalp::wire
