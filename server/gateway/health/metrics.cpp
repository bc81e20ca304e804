#include "server/gateway/health/metrics.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "support/program/text/metric_text.h"

namespace telepalp::gateway {
namespace {

using program::metric_heading, program::metric_text;

std::string by_topic(const hub::Hub& hub, const std::string& name, const std::string& help,
                     std::uint64_t hub::Hub::TopicCount::*count) {
  std::string text = metric_heading(name, "counter", help);
  for (const auto& [topic, counts] : hub.topic_counts())
    text += name + "{topic=\"" + std::string(topic) + "\"} " + std::to_string(counts.*count) + "\n";
  return text;
}

std::string refused_datagrams(const hub::DatagramCounts& datagrams) {
  const std::string name = "telepalp_datagrams_refused_total";
  std::string text = metric_heading(
      name, "counter",
      "UDP datagrams that were dropped without an answer, by reason; stranger: of no connected program.");
  for (const auto& [why, count] : {std::pair{"stranger", datagrams.strangers},
                                   {"malformed", datagrams.malformed},
                                   {"replayed", datagrams.replayed},
                                   {"forged", datagrams.forged}})
    text += name + "{why=\"" + why + "\"} " + std::to_string(count) + "\n";
  return text;
}

}  // namespace

std::string metrics_text(const hub::Hub& hub, const access::Access::Counts& access,
                         const hub::DatagramCounts& datagrams, const ServerFacts& facts) {
  using Count = hub::Hub::TopicCount;
  const std::vector<hub::Hub::SubscriberCount> subscribers = hub.subscriber_counts();
  const auto by_datagram =
      std::count_if(subscribers.begin(), subscribers.end(),
                    [](const hub::Hub::SubscriberCount& subscriber) { return subscriber.by_datagram; });
  return by_topic(hub, "telepalp_published_messages_total", "Messages published, by topic.", &Count::published) +
         by_topic(hub, "telepalp_published_bytes_total", "Bytes published, by topic.", &Count::bytes) +
         by_topic(hub, "telepalp_sent_messages_total", "Messages sent to subscribers, by topic.", &Count::sent) +
         by_topic(hub, "telepalp_dropped_messages_total", "Messages dropped for slow subscribers, by topic.",
                  &Count::dropped) +
         metric_text("telepalp_subscribers", "gauge", "Stations, recorders and browsers that are connected.",
                     subscribers.size()) +
         metric_text("telepalp_datagram_subscribers", "gauge",
                     "Connected stations and recorders whose images go by encrypted UDP datagrams.",
                     static_cast<std::uint64_t>(by_datagram)) +
         metric_text("telepalp_datagrams_taken_total", "counter", "UDP datagrams that were accepted.",
                     datagrams.taken) +
         refused_datagrams(datagrams) +
         metric_text("telepalp_browser_connections", "gauge", "Open connections of browsers to the web port.",
                     facts.browsers) +
         metric_text("telepalp_waiting_bytes", "gauge",
                     "Bytes that wait to be sent to subscribers; images are not counted.", hub.waiting_bytes()) +
         metric_text("telepalp_touch_held", "gauge", "1 while a doctor's station holds the touch, else 0.",
                     facts.touch_is_held ? 1 : 0) +
         metric_text("telepalp_healthy", "gauge", "1 while the health check finds no problem, else 0.",
                     facts.is_healthy ? 1 : 0) +
         metric_text("telepalp_joined_total", "counter", "Connections that were accepted since the start.",
                     access.joined) +
         metric_text("telepalp_refused_total", "counter", "Keys, tokens, operations and connections that were refused.",
                     access.refused) +
         metric_text("telepalp_audit_lines", "gauge", "Lines of the audit log.", access.audit_lines) +
         metric_text("telepalp_audit_lines_not_written_total", "counter",
                     "Lines of the audit log that could not be written, for example to a full disk.",
                     access.audit_not_written);
}

}  // namespace telepalp::gateway
