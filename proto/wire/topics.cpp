#include "proto/wire/topics.h"

#include <algorithm>

namespace telepalp::wire {
namespace {

constexpr std::uint8_t kMostDatagramChannels = 16;  // a report of a datagram link names them by a bit each

constexpr bool names_and_channels_are_unique() {
  for (std::size_t i = 0; i < kTopics.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (kTopics[i].name == kTopics[j].name) return false;
      if (kTopics[i].has_deadline() && kTopics[i].datagram_channel == kTopics[j].datagram_channel) return false;
    }
  return true;
}

static_assert(names_and_channels_are_unique());
static_assert(std::ranges::all_of(kTopics, [](const Topic& topic) {
  return topic.datagram_channel.value_or(0) < kMostDatagramChannels;
}));
static_assert(std::ranges::all_of(kTopics,
                                  [](const Topic& topic) {
                                    const bool limited =
                                        topic.most_from_peer.messages_per_s > 0 && topic.most_from_peer.KiB_per_s > 0;
                                    return limited == (topic.publisher == Publisher::Station);
                                  }),
              "each topic that a peer may publish has a limit, and no other topic has one");
static_assert(std::ranges::none_of(kTopics, [](const Topic& topic) { return topic.latched() && topic.predicted; }),
              "the newest message alone must be readable by a new subscriber");

template <class Matches>
std::optional<Topic> first_topic(Matches matches) noexcept {
  const auto found = std::ranges::find_if(kTopics, matches);
  return found == kTopics.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

std::optional<Topic> find_topic(std::string_view name) noexcept {
  return first_topic([&](const Topic& topic) { return topic.name == name; });
}

std::optional<Topic> topic_of_datagram_channel(std::uint8_t channel) noexcept {
  return first_topic([&](const Topic& topic) { return topic.datagram_channel == channel; });
}

}  // namespace telepalp::wire
