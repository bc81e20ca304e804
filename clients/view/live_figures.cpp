#include "clients/view/live_figures.h"

#include <cstdio>

#include "proto/words/numbers/quantile.h"
#include "support/program/json.h"

namespace telepalp::view {
namespace {

/// 0 without values.
double quantile(std::vector<float> values, double share) {
  return values.empty() ? 0.0 : double{quantile_of(values, share)};
}

}  // namespace

void LiveFigures::add(const wire::Message& message, SessionTime now) {
  Heard& heard = topics_[message.topic.name];
  ++heard.messages;
  heard.bytes += message.payload->size();
  if (heard.ages_ms.size() < kMostAges)
    heard.ages_ms.push_back(static_cast<float>(to_milliseconds(now - message.published)));
}

std::vector<LiveFigures::Topic> LiveFigures::topics(
    double seconds, const std::map<std::string_view, wire::ReceivedCount>& received) const {
  std::vector<Topic> topics;
  for (const auto& [name, heard] : topics_) {
    const auto counted = received.find(name);
    topics.push_back({.name = std::string(name),
                      .per_s = static_cast<double>(heard.messages) / seconds,
                      .bytes_per_s = static_cast<double>(heard.bytes) / seconds,
                      .age_p50_ms = quantile(heard.ages_ms, 0.5),
                      .age_p99_ms = quantile(heard.ages_ms, 0.99),
                      .missed = counted == received.end() ? 0 : counted->second.missed});
  }
  return topics;
}

std::string in_table(const std::vector<LiveFigures::Topic>& topics, double clock_uncertainty_ms) {
  std::string text = "topic                messages/s      kB/s  age p50 ms  age p99 ms   missed\n";
  char line[200];
  for (const LiveFigures::Topic& topic : topics) {
    std::snprintf(line, sizeof line, "%-22s %8.1f %9.1f %11.2f %11.2f %8llu\n", topic.name.c_str(), topic.per_s,
                  1e-3 * topic.bytes_per_s, topic.age_p50_ms, topic.age_p99_ms,
                  static_cast<unsigned long long>(topic.missed));
    text += line;
  }
  std::snprintf(
      line, sizeof line,
      "age: time from publication to arrival, to within %.2f ms (this computer estimates the server's clock). "
      "missed: messages published, but not received\n",
      clock_uncertainty_ms);
  return text + line;
}

std::string in_json(const std::vector<LiveFigures::Topic>& topics, double seconds, double clock_uncertainty_ms) {
  program::Json json;
  json.begin_object();
  json.add("seconds", seconds);
  json.add("clock_uncertainty_ms", clock_uncertainty_ms);
  json.begin_object("topics");
  for (const LiveFigures::Topic& topic : topics) {
    json.begin_object(topic.name);
    json.add("per_s", topic.per_s);
    json.add("bytes_per_s", topic.bytes_per_s);
    json.add("age_p50_ms", topic.age_p50_ms);
    json.add("age_p99_ms", topic.age_p99_ms);
    json.add("missed", topic.missed);
    json.end_object();
  }
  json.end_object();
  json.end_object();
  return std::move(json).finish();
}

}  // namespace telepalp::view
