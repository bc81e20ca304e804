#include "server/hub/hub.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace telepalp::hub {
namespace {

bool is_only_by_name(std::string_view name) noexcept {
  const std::optional<wire::Topic> topic = wire::find_topic(name);
  return topic && topic->only_by_name;
}

bool matches(std::string_view wanted, std::string_view topic) noexcept {
  if (!wanted.empty() && wanted.back() == '*')
    return topic.starts_with(wanted.substr(0, wanted.size() - 1)) && !is_only_by_name(topic);
  return wanted == topic;
}

/// True for camera images, which may come in several grades.
bool has_grades(const wire::Topic& topic) noexcept {
  return topic.has_deadline() && topic.publisher == wire::Publisher::Server;
}

plan::Grade grade_in(const wire::Topic& topic, plan::Grade subscriber) noexcept {
  return has_grades(topic) ? subscriber : plan::Grade::Full;
}

bool wants(const std::vector<std::string>& topics, std::string_view topic) noexcept {
  return std::any_of(topics.begin(), topics.end(), [&](const std::string& wanted) { return matches(wanted, topic); });
}

}  // namespace

SubscriberId Hub::join(std::string name, std::string address, std::function<void()> wake, std::uint32_t sender) {
  Subscriber subscriber;
  subscriber.count.name = std::move(name);
  subscriber.count.address = std::move(address);
  subscriber.count.sender = sender;
  subscriber.wake = std::move(wake);
  subscribers_.emplace(++last_id_, std::move(subscriber));
  return last_id_;
}

void Hub::note_way(SubscriberId id, std::string_view way) {
  const auto found = subscribers_.find(id);
  if (found == subscribers_.end()) return;
  std::string& address = found->second.count.address;
  address = address.substr(0, address.find(' ')) + " " + std::string(way);
}

template <class Matches>
void Hub::remove_waiting(Subscriber& subscriber, Matches matches) {
  const std::size_t before = subscriber.queue.other_bytes();
  subscriber.queue.remove_if([&](const wire::Message& message) {
    if (matches(message)) drop(subscriber.count, message);
    return matches(message);
  });
  waiting_bytes_ -= before - subscriber.queue.other_bytes();
}

void Hub::leave(SubscriberId id) {
  const auto found = subscribers_.find(id);
  if (found == subscribers_.end()) return;
  remove_waiting(found->second, [](const wire::Message&) { return true; });
  subscribers_.erase(found);
}

void Hub::subscribe(SubscriberId id, const std::vector<std::string>& topics) {
  const auto found = subscribers_.find(id);
  if (found == subscribers_.end()) return;
  Subscriber& subscriber = found->second;
  const std::vector<std::string> before = std::exchange(subscriber.topics, topics);
  forget_unwanted(subscriber);
  for (const auto& [name, message] : latched_)
    if (wants(topics, name) && !wants(before, name)) offer(subscriber, message);
  for (const wire::Topic& topic : wire::kTopics)
    if (wants(topics, topic.name) && !wants(before, topic.name) && stream_for(subscriber, topic).keys.in_groups)
      request_from_publisher(subscriber, topic);
}

/// Drops queued messages of topics that the subscriber no longer wants. A viewer that lost its reference frame
/// unsubscribes and subscribes again, and older messages are useless to it.
void Hub::forget_unwanted(Subscriber& subscriber) {
  remove_waiting(subscriber,
                 [&](const wire::Message& message) { return !wants(subscriber.topics, message.topic.name); });
  for (auto& [name, position] : subscriber.positions)
    if (!wants(subscriber.topics, name)) position.group = {};
}

void Hub::publish(wire::Message message, plan::Grade grade) {
  TopicCount& count = topics_[message.topic.name];
  const std::uint64_t number = message.sequence;
  Stream& stream = streams_[{message.topic.name, grade}];
  ++count.published;
  ++stream.published;
  if (!keeps_numbers_ || number == 0) message.sequence = stream.published;
  count.bytes += message.payload->size();
  if (lacks_reference(stream.keys, number, message.key_frame)) forget_references(message.topic, grade);
  stream.keys = after_publishing(stream.keys, message.key_frame, message.published, number);
  if (message.topic.latched()) latched_.insert_or_assign(message.topic.name, message);
  for (auto& [id, subscriber] : subscribers_)
    if (grade_in(message.topic, subscriber.count.grade) == grade && wants(subscriber.topics, message.topic.name))
      offer(subscriber, message);
  drop_beyond_the_bound();
}

void Hub::give(SubscriberId id, plan::Grade grade) {
  const auto found = subscribers_.find(id);
  if (found == subscribers_.end() || std::exchange(found->second.count.grade, grade) == grade) return;
  Subscriber& subscriber = found->second;
  for (const wire::Topic& topic : wire::kTopics) {
    if (!has_grades(topic)) continue;
    Position& position = subscriber.positions[topic.name];
    position.group = {};
    position.is_new_grade = true;
    if (wants(subscriber.topics, topic.name) && stream_for(subscriber, topic).keys.in_groups)
      request_from_publisher(subscriber, topic);
  }
}

void Hub::note_shows_images(SubscriberId id) {
  if (const auto found = subscribers_.find(id); found != subscribers_.end()) found->second.count.shows_images = true;
}

Hub::Stream& Hub::stream_for(const Subscriber& subscriber, const wire::Topic& topic) {
  return streams_[{topic.name, grade_in(topic, subscriber.count.grade)}];
}

/// The hub missed a message of the stream, so no subscriber has the reference frame of the next predicted one.
void Hub::forget_references(const wire::Topic& topic, plan::Grade grade) {
  for (auto& [id, subscriber] : subscribers_)
    if (grade_in(topic, subscriber.count.grade) == grade) subscriber.positions[topic.name].group = {};
}

bool Hub::is_wanted(std::string_view topic, plan::Grade grade) const {
  return std::any_of(subscribers_.begin(), subscribers_.end(), [&](const auto& subscriber) {
    return subscriber.second.count.grade == grade && wants(subscriber.second.topics, topic);
  });
}

bool Hub::takes(SubscriberId id, std::string_view topic) const {
  const auto found = subscribers_.find(id);
  return found != subscribers_.end() && wants(found->second.topics, topic);
}

std::vector<SubscriberId> Hub::subscribers() const {
  std::vector<SubscriberId> ids;
  for (const auto& [id, subscriber] : subscribers_) ids.push_back(id);
  return ids;
}

bool Hub::is_wanted(std::string_view topic) const {
  return std::any_of(subscribers_.begin(), subscribers_.end(),
                     [&](const auto& subscriber) { return wants(subscriber.second.topics, topic); });
}

bool Hub::is_missed(std::string_view topic) const {
  return std::any_of(subscribers_.begin(), subscribers_.end(), [&](const auto& entry) {
    const Subscriber& subscriber = entry.second;
    return wants(subscriber.topics, topic) && !subscriber.count.topics.contains(topic);
  });
}

/// Drops the oldest message of the subscriber with the most queued bytes, until the bound holds.
void Hub::drop_beyond_the_bound() {
  const auto fuller = [](const auto& a, const auto& b) {
    return a.second.queue.other_bytes() < b.second.queue.other_bytes();
  };
  while (waiting_bytes_ > kMaxWaitingBytes) {
    Subscriber& fullest = std::max_element(subscribers_.begin(), subscribers_.end(), fuller)->second;
    const std::optional<wire::Message> gone = fullest.queue.drop_of_largest();
    waiting_bytes_ -= gone->payload->size();
    drop(fullest.count, *gone);
  }
}

std::vector<wire::Message> Hub::put_in_queue(Subscriber& subscriber, const wire::Message& message) {
  const std::size_t before = subscriber.queue.other_bytes();
  std::vector<wire::Message> gone = subscriber.queue.push(message);
  waiting_bytes_ = waiting_bytes_ + subscriber.queue.other_bytes() - before;
  return gone;
}

bool Hub::is_taken(std::string_view topic, std::string_view other_than) const noexcept {
  return std::any_of(subscribers_.begin(), subscribers_.end(), [&](const auto& entry) {
    const Subscriber& subscriber = entry.second;
    return subscriber.count.name != other_than &&
           std::find(subscriber.topics.begin(), subscriber.topics.end(), topic) != subscriber.topics.end();
  });
}

void Hub::request_key_frame(SubscriberId id, const wire::Topic& topic, SessionTime undecodable) {
  const auto found = subscribers_.find(id);
  if (found == subscribers_.end() || !wants(found->second.topics, topic.name)) return;
  const wire::KeyFrameState& keys = stream_for(found->second, topic).keys;
  if (!keys.in_groups || !still_needs_key_frame(keys, undecodable)) return;
  start_anew(found->second, topic);
}

void Hub::restart_group(SubscriberId id, const wire::Topic& topic) {
  const auto found = subscribers_.find(id);
  if (found == subscribers_.end() || !stream_for(found->second, topic).keys.in_groups) return;
  start_anew(found->second, topic);
}

/// The next message of `topic` to the subscriber is a key frame.
void Hub::start_anew(Subscriber& subscriber, const wire::Topic& topic) {
  subscriber.positions[topic.name].group = {};
  remove_waiting(subscriber, [&](const wire::Message& message) { return message.topic.name == topic.name; });
  if (wants(subscriber.topics, topic.name)) request_from_publisher(subscriber, topic);
}

Hub::TopicCount Hub::topic_count(SubscriberId id, std::string_view topic) const {
  const auto subscriber = subscribers_.find(id);
  if (subscriber == subscribers_.end()) return {};
  const auto found = subscriber->second.count.topics.find(topic);
  return found == subscriber->second.count.topics.end() ? TopicCount{} : found->second;
}

void Hub::note_share(SubscriberId id, std::optional<double> share_B_per_s) {
  if (const auto found = subscribers_.find(id); found != subscribers_.end())
    found->second.count.share_B_per_s = share_B_per_s;
}

void Hub::send_by_datagram(SubscriberId id, bool on) {
  const auto found = subscribers_.find(id);
  if (found == subscribers_.end() || found->second.count.by_datagram == on) return;
  Subscriber& subscriber = found->second;
  remove_waiting(subscriber, [](const wire::Message& message) { return message.topic.has_deadline(); });
  subscriber.count.by_datagram = on;
  subscriber.queue.send_by_datagram(on);
  for (const wire::Topic& topic : wire::kTopics)
    if (topic.has_deadline()) restart_group(id, topic);
}

std::optional<wire::Message> Hub::next_for_datagram(SubscriberId id, wire::Wanted wanted) {
  const auto found = subscribers_.find(id);
  if (found == subscribers_.end()) return std::nullopt;
  std::vector<wire::Message> gone;
  std::optional<wire::Message> message = found->second.queue.pop_newest(gone, wanted);
  for (const wire::Message& older : gone) crowd_out(found->second.count, older);
  if (message) count_sent(found->second, *message);
  return message;
}

void Hub::request_from_publisher(const Subscriber& subscriber, const wire::Topic& topic) {
  if (std::exchange(stream_for(subscriber, topic).keys.requested, true)) return;
  if (key_frame_requested_) key_frame_requested_(topic.name);
}

void Hub::drop(SubscriberCount& subscriber, const wire::Message& message) {
  ++subscriber.topics[message.topic.name].dropped;
  ++topics_[message.topic.name].dropped;
}

/// Drops a message that the subscriber could have decoded, because its line has no room.
void Hub::crowd_out(SubscriberCount& subscriber, const wire::Message& message) {
  if (has_grades(message.topic)) ++subscriber.crowded_out;
  drop(subscriber, message);
}

void Hub::offer(Subscriber& subscriber, wire::Message message) {
  ++subscriber.count.topics[message.topic.name].published;
  Position& position = subscriber.positions[message.topic.name];
  if (std::exchange(position.is_new_grade, false))
    position.shift = static_cast<std::int64_t>(position.offered + 1 - message.sequence);
  message.sequence += static_cast<std::uint64_t>(position.shift);
  position.offered = message.sequence;
  const bool was_empty = subscriber.queue.empty() ||
                         subscriber.count.by_datagram;  // TCP may wait while datagrams are sent, and the reverse
  const bool usable = can_decode(position.group, message.sequence, message.key_frame);
  const std::vector<wire::Message> gone = usable ? put_in_queue(subscriber, message) : std::vector{message};
  if (usable && has_grades(message.topic)) ++subscriber.count.images;
  for (const wire::Message& lost : gone) usable ? crowd_out(subscriber.count, lost) : drop(subscriber.count, lost);
  const bool queued = gone.empty() || gone.back().sequence != message.sequence;
  position.group = {.last = queued ? message.sequence : 0};
  if (!queued && subscriber.queue.waiting(message.topic) == 0) request_from_publisher(subscriber, message.topic);
  if (queued && was_empty) subscriber.wake();
}

std::optional<wire::Message> Hub::next(SubscriberId id) {
  const auto found = subscribers_.find(id);
  if (found == subscribers_.end()) return std::nullopt;
  const std::size_t before = found->second.queue.other_bytes();
  std::optional<wire::Message> message = found->second.queue.pop();
  waiting_bytes_ -= before - found->second.queue.other_bytes();
  if (message) count_sent(found->second, *message);
  return message;
}

void Hub::count_sent(Subscriber& subscriber, const wire::Message& message) {
  TopicCount& count = subscriber.count.topics[message.topic.name];
  ++count.sent;
  count.bytes += message.payload->size();
  ++topics_[message.topic.name].sent;
  // A subscriber whose queue was full needs a key frame. The hub requests the key frame only when the subscriber reads
  // again, because a subscriber that reads nothing would cause one key frame after another.
  if (subscriber.positions[message.topic.name].group.last == 0) request_from_publisher(subscriber, message.topic);
}

std::uint64_t Hub::SubscriberCount::sent() const noexcept {
  return std::accumulate(topics.begin(), topics.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& topic) { return sum + topic.second.sent; });
}

std::uint64_t Hub::SubscriberCount::dropped() const noexcept {
  return std::accumulate(topics.begin(), topics.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& topic) { return sum + topic.second.dropped; });
}

std::vector<Hub::SubscriberCount> Hub::subscriber_counts() const {
  std::vector<SubscriberCount> counts;
  for (const auto& [id, subscriber] : subscribers_) counts.push_back(subscriber.count);
  return counts;
}

}  // namespace telepalp::hub
