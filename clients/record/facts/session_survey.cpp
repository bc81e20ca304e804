#include "clients/record/facts/session_survey.h"

#include <google/protobuf/arena.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <cstdlib>

#include "proto/wire/mcap/format/schemas.h"

namespace telepalp::record {
namespace {

constexpr std::size_t kMostPeers = 1000;  // a malicious file cannot make the survey grow further

SessionFacts::Topic describe(const wire::mcap::StoredChannel& channel) {
  SessionFacts::Topic topic{.name = channel.channel.topic,
                            .type = channel.schema == nullptr ? "" : channel.schema->name,
                            .is_ours = channel.topic.has_value()};
  if (channel.topic)
    topic.has_other_version = channel.schema->data != wire::file_descriptor_set(*wire::descriptor_of(*channel.topic));
  return topic;
}

bool parses(const wire::Topic& topic, const std::string& payload) {
  google::protobuf::Arena arena;
  const auto* const prototype =
      google::protobuf::MessageFactory::generated_factory()->GetPrototype(wire::descriptor_of(topic));
  return prototype->New(&arena)->ParseFromString(payload);
}

}  // namespace

void SessionSurvey::add(const wire::mcap::StoredMessage& message) {
  const auto place = topics_.find(message.channel->channel.topic);
  TopicSoFar& so_far =
      place != topics_.end()
          ? place->second
          : topics_.emplace(message.channel->channel.topic, TopicSoFar{describe(*message.channel)}).first->second;
  if (so_far.topic.messages == 0) so_far.topic.begins_with_key_frame = is_key_frame(message);
  count(so_far, message.record);
  if (message.channel->topic) read(so_far, message);
}

void SessionSurvey::count(TopicSoFar& so_far, const wire::mcap::MessageRecord& record) {
  SessionFacts::Topic& topic = so_far.topic;
  topic.bytes += record.data.size();
  if (topic.messages++ > 0) {
    if (record.sequence > so_far.last_sequence + 1) topic.lost += record.sequence - so_far.last_sequence - 1;
    if (record.log_time < so_far.newest_time) ++topic.back_in_time;
    if (record.log_time > so_far.newest_time)
      topic.longest_gap_s =
          std::max(topic.longest_gap_s, static_cast<double>(record.log_time - so_far.newest_time) * 1e-9);
  }
  so_far.last_sequence = record.sequence;
  so_far.newest_time = std::max(so_far.newest_time, record.log_time);
}

void SessionSurvey::read(TopicSoFar& so_far, const wire::mcap::StoredMessage& stored) {
  const std::string_view topic = stored.channel->topic->name;
  const std::string payload(stored.record.data);
  if (!parses(*stored.channel->topic, payload)) {
    ++so_far.topic.unreadable;
    return;
  }
  if (stored.channel->topic->publisher == wire::Publisher::Station) note_sender(payload);
  if (topic == wire::kServerStats.name) note_server_stats(payload);
  if (topic == wire::kStationStats.name) note_station_stats(payload);
  if (topic == wire::kClock.name) note_clock(payload);
}

void SessionSurvey::note_sender(const std::string& payload) {
  msg::Sender field;
  if (!field.ParseFromString(payload)) return;
  if (senders_.size() >= kMostPeers && !senders_.contains(field.sender())) return;
  SessionFacts::Peer& peer = senders_[field.sender()];
  peer.sender = field.sender();
  ++peer.messages;
}

void SessionSurvey::note_server_stats(const std::string& payload) {
  msg::ServerStats stats;
  if (!stats.ParseFromString(payload)) return;
  for (const msg::ServerStats::PerSubscriber& subscriber : stats.subscribers()) {
    const std::pair key(subscriber.name(), subscriber.address());
    if (dropped_for_.size() >= kMostPeers && !dropped_for_.contains(key)) return;
    const auto [place, is_new] = dropped_for_.try_emplace(key);
    DropsOfPeer& drops = place->second;
    drops.sender = subscriber.sender();
    if (is_new) drops.first = subscriber.dropped();
    drops.last = std::max(drops.last, subscriber.dropped());
  }
}

void SessionSurvey::note_station_stats(const std::string& payload) {
  msg::StationStats stats;
  if (!stats.ParseFromString(payload) || !senders_.contains(stats.sender())) return;
  senders_[stats.sender()].dropped_by_it = stats.frames_dropped() + stats.telemetry_dropped();
}

void SessionSurvey::note_clock(const std::string& payload) {
  msg::Clock now;
  if (!now.ParseFromString(payload)) return;
  const auto offset_ns = [](const msg::Clock& clock) {
    return static_cast<std::int64_t>(clock.utc_ns() - clock.session_ns());
  };
  if (clock_.count++ == 0) clock_.first = clock_.last = now;
  const std::int64_t step_ns = static_cast<std::int64_t>(static_cast<std::uint64_t>(offset_ns(now)) -
                                                         static_cast<std::uint64_t>(offset_ns(clock_.last)));
  if (step_ns != INT64_MIN) clock_.largest_step_ns = std::max(clock_.largest_step_ns, std::abs(step_ns));
  clock_.last = now;
}

void SessionSurvey::finish(SessionFacts& facts) {
  for (auto& [name, so_far] : topics_) {
    SessionFacts::Topic& topic = so_far.topic;
    if (facts.seconds > 0.0 && topic.messages > 1)
      topic.rate_Hz = static_cast<double>(topic.messages - 1) / facts.seconds;
    facts.topics.push_back(std::move(topic));
  }
  for (const auto& [key, drops] : dropped_for_) {
    SessionFacts::Peer peer = drops.sender != 0 ? senders_[drops.sender] : SessionFacts::Peer{};
    if (drops.sender != 0) senders_.erase(drops.sender);
    peer.sender = drops.sender;
    peer.name = key.first;
    peer.address = key.second;
    peer.dropped_before_it = drops.last - drops.first;
    facts.peers.push_back(std::move(peer));
  }
  for (const auto& [number, peer] : senders_) facts.peers.push_back(peer);
  const auto session_s = static_cast<double>(clock_.last.session_ns() - clock_.first.session_ns()) * 1e-9;
  if (clock_.count < 2 || clock_.last.session_ns() <= clock_.first.session_ns()) return;
  const double utc_s =
      static_cast<double>(static_cast<std::int64_t>(clock_.last.utc_ns() - clock_.first.utc_ns())) * 1e-9;
  facts.clock = SessionFacts::Clock{.drift_ppm = (utc_s / session_s - 1.0) * 1e6,
                                    .largest_step_ms = static_cast<double>(clock_.largest_step_ns) * 1e-6};
}

}  // namespace telepalp::record
