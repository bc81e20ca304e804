#include "proto/wire/topics.h"

#include <algorithm>

namespace telepalp::wire {

std::optional<Topic> find_topic(std::string_view name) noexcept {
  for (const Topic& topic : kTopics)
    if (topic.name == name) return topic;
  return std::nullopt;
}

bool is_latched(std::string_view topic) noexcept {
  constexpr std::array kLatched{kCameraInfo, kCameraColorInfo, kCameraStatus, kHandHolder, kStationInside};
  return std::ranges::find(kLatched, topic, &Topic::name) != kLatched.end();
}

}  // namespace telepalp::wire
