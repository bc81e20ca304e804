#include "server/hub/upstream.h"

#include <algorithm>
#include <array>

#include "messages/station.pb.h"
#include "proto/wire/camera/depth_window_message.h"
#include "proto/wire/inside/inside_message.h"
#include "proto/words/demand.h"

namespace telepalp::hub {
namespace {

/// What a payload must pass. Each topic whose publisher is a station has one.
struct Check {
  std::string_view topic;
  bool (*passes)(const std::string&);
};

template <class Proto>
bool parses(const std::string& payload) {
  return Proto().ParseFromString(payload);
}

/// For topics whose values the server checks, too.
template <class Proto>
bool parses_and_is_valid(const std::string& payload) {
  Proto message;
  return message.ParseFromString(payload) && wire::is_valid(message);
}

constexpr double kKiB = 1024.0;
constexpr std::array kChecks{Check{wire::kStationState.name, parses<msg::StationState>},
                             Check{wire::kStationTicks.name, parses<msg::StationTicks>},
                             Check{wire::kStationSurface.name, parses<msg::SurfaceReport>},
                             Check{wire::kStationCompensation.name, parses<msg::StationCompensation>},
                             Check{wire::kStationEvents.name, parses<msg::StationEvent>},
                             Check{wire::kStationStats.name, parses<msg::StationStats>},
                             Check{wire::kStationUltrasound.name, parses_and_is_valid<msg::UltrasoundImage>},
                             Check{wire::kStationWindow.name, parses_and_is_valid<msg::WindowRequest>},
                             Check{wire::kStationInside.name, parses_and_is_valid<msg::InnerStructures>}};
static_assert(std::ranges::all_of(wire::kTopics, [](const wire::Topic& topic) {
  return (std::ranges::count(kChecks, topic.name, &Check::topic) == 1) == may_publish_upstream(topic);
}));

}  // namespace

bool is_valid_upstream(const wire::Message& message) {
  const auto check = std::ranges::find(kChecks, message.topic.name, &Check::topic);
  return check != kChecks.end() && message.payload->size() <= kMaxUpstreamBytes && check->passes(*message.payload);
}

Rate upstream_rate(const wire::Topic& topic) {
  constexpr double kBurstMessages = 512;  // a client's queue holds 256 messages of a topic
  constexpr double kLeastBurst = 256 * kKiB;
  demand(may_publish_upstream(topic), "the rate limit is requested only for a topic that peers may publish");
  const double bytes_per_s = topic.most_from_peer.KiB_per_s * kKiB;
  return {.messages_per_s = static_cast<double>(topic.most_from_peer.messages_per_s),
          .bytes_per_s = bytes_per_s,
          .burst_messages = kBurstMessages,
          .burst_bytes = std::max(kLeastBurst, 2.0 * bytes_per_s)};
}

bool UpstreamRates::passes(const wire::Message& message, RateLimiter::TimePoint now) {
  auto found = limiters_.find(message.topic.name);
  if (found == limiters_.end())
    found = limiters_.emplace(message.topic.name, RateLimiter(upstream_rate(message.topic))).first;
  return found->second.passes(message.payload->size(), now);
}

wire::Message with_sender(wire::Message message, std::uint32_t sender) {
  msg::Sender field;  // in Protobuf the last value of a repeated scalar field on the wire counts
  field.set_sender(sender);
  message.payload = std::make_shared<const std::string>(*message.payload + field.SerializeAsString());
  return message;
}

}  // namespace telepalp::hub
