#include "proto/wire/topics.h"

namespace telepalp::wire {

std::optional<Topic> find_topic(std::string_view name) noexcept {
  for (const Topic& topic : kTopics)
    if (topic.name == name) return topic;
  return std::nullopt;
}

}  // namespace telepalp::wire
