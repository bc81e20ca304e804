#include "server/hub/server_stats.h"

namespace telepalp::hub {
namespace {

void fill(msg::ServerStats::PerTopic& row, std::string_view topic, const Hub::TopicCount& count) {
  row.set_topic(std::string(topic));
  row.set_published(count.published);
  row.set_sent(count.sent);
  row.set_dropped(count.dropped);
  row.set_bytes(count.bytes);
}

}  // namespace

msg::ServerStats server_stats(const Hub& hub, const DatagramCounts& datagrams, SessionTime now) {
  msg::ServerStats stats;
  stats.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(now)));
  for (const auto& [topic, count] : hub.topic_counts()) fill(*stats.add_topics(), topic, count);
  for (const Hub::SubscriberCount& subscriber : hub.subscriber_counts()) {
    msg::ServerStats::PerSubscriber& row = *stats.add_subscribers();
    row.set_name(subscriber.name);
    row.set_address(subscriber.address);
    row.set_sender(subscriber.sender);
    row.set_by_datagram(subscriber.by_datagram);
    if (subscriber.share_B_per_s) row.set_share_b_per_s(*subscriber.share_B_per_s);
    row.set_sent(subscriber.sent());
    row.set_dropped(subscriber.dropped());
    for (const auto& [topic, count] : subscriber.topics) fill(*row.add_topics(), topic, count);
  }
  msg::ServerStats::Datagrams& port = *stats.mutable_datagrams();
  port.set_taken(datagrams.taken);
  port.set_strangers(datagrams.strangers);
  port.set_malformed(datagrams.malformed);
  port.set_replayed(datagrams.replayed);
  port.set_forged(datagrams.forged);
  return stats;
}

}  // namespace telepalp::hub
