#include "server/hub/upstream.h"

#include <algorithm>
#include <array>

#include "messages/station.pb.h"
#include "proto/wire/inside/inside_message.h"
#include "proto/words/demand.h"

namespace telepalp::hub {
namespace {

struct Allowed {
  std::string_view topic;
  bool (*parses)(const std::string&);
  double messages_per_s;
  double bytes_per_s;
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
constexpr std::array kAllowed{
    Allowed{wire::kStationState.name, parses<msg::StationState>, 250, 256 * kKiB},
    Allowed{wire::kStationTicks.name, parses<msg::StationTicks>, 250, 1024 * kKiB},
    Allowed{wire::kStationSurface.name, parses<msg::SurfaceReport>, 150, 128 * kKiB},
    Allowed{wire::kStationCompensation.name, parses<msg::StationCompensation>, 250, 128 * kKiB},
    Allowed{wire::kStationEvents.name, parses<msg::StationEvent>, 50, 64 * kKiB},
    Allowed{wire::kStationStats.name, parses<msg::StationStats>, 10, 64 * kKiB},
    Allowed{wire::kStationUltrasound.name, parses_and_is_valid<msg::UltrasoundImage>, 60, 1024 * kKiB},
    Allowed{wire::kStationInside.name, parses_and_is_valid<msg::InnerStructures>, 1, 512 * kKiB}};

const Allowed* find(const wire::Topic& topic) noexcept {
  const auto found =
      std::find_if(kAllowed.begin(), kAllowed.end(), [&](const Allowed& row) { return row.topic == topic.name; });
  return found == kAllowed.end() ? nullptr : &*found;
}

}  // namespace

bool may_publish_upstream(const wire::Topic& topic) noexcept { return find(topic) != nullptr; }

bool is_valid_upstream(const wire::Message& message) {
  const Allowed* allowed = find(message.topic);
  return allowed && message.payload->size() <= kMaxUpstreamBytes && allowed->parses(*message.payload);
}

Rate upstream_rate(const wire::Topic& topic) {
  constexpr double kBurstMessages = 512;  // a client's queue holds 256 messages of a topic
  constexpr double kLeastBurst = 256 * kKiB;
  const Allowed* allowed = find(topic);
  demand(allowed != nullptr, "the rate limit is requested only for a topic that peers may publish");
  return {.messages_per_s = allowed->messages_per_s,
          .bytes_per_s = allowed->bytes_per_s,
          .burst_messages = kBurstMessages,
          .burst_bytes = std::max(kLeastBurst, 2.0 * allowed->bytes_per_s)};
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
