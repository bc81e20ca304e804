#include "server/origin/state_publisher.h"

#include <algorithm>
#include <memory>

#include "proto/wire/message.h"

namespace telepalp::origin {

void StatePublisher::look() {
  const auto now = std::chrono::steady_clock::now();
  for (const StateTopic& row : kStateTopics) {
    const auto found = published_.find(row.topic.name);
    const bool is_due = found == published_.end() || now - found->second.looked_at >= row.every;
    if (is_due && hub_.is_wanted(row.topic.name)) publish_if_changed(row);
  }
}

void StatePublisher::commanded() {
  for (const StateTopic& row : kStateTopics)
    if (hub_.is_wanted(row.topic.name)) publish_if_changed(row);
}

void StatePublisher::expect_subscriber(const std::vector<std::string>& topics) {
  for (const StateTopic& row : kStateTopics)
    if (std::ranges::find(topics, row.topic.name) != topics.end()) publish_if_changed(row);
}

SessionTime StatePublisher::published_at(std::string_view path) const {
  const auto found = published_.find(path);
  return found == published_.end() ? SessionTime{} : found->second.at;
}

void StatePublisher::publish_if_changed(const StateTopic& row) {
  const auto resource = resources_.find(row.topic.name);
  if (resource == resources_.end()) return;
  std::string state = resource->second.state()->SerializeAsString();
  const auto [last, is_first] = published_.try_emplace(row.topic.name);
  last->second.looked_at = std::chrono::steady_clock::now();
  if (!is_first && last->second.state == state) return;
  last->second.at = now_();
  last->second.state = state;
  hub_.publish({row.topic, last->second.at, std::make_shared<const std::string>(std::move(state)), 0, true});
}

}  // namespace telepalp::origin
