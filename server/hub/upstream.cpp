#include "server/hub/upstream.h"

#include <algorithm>
#include <array>

#include "messages/station.pb.h"

namespace telepalp::server {
namespace {

struct Allowed {
  std::string_view topic;
  bool (*parses)(const std::string&);
};

template <class Proto>
bool parses(const std::string& payload) {
  return Proto().ParseFromString(payload);
}

constexpr std::array kAllowed{Allowed{wire::kStationState.name, parses<msg::StationState>},
                              Allowed{wire::kStationTicks.name, parses<msg::StationTicks>},
                              Allowed{wire::kStationSurface.name, parses<msg::SurfaceReport>},
                              Allowed{wire::kStationCompensation.name, parses<msg::StationCompensation>},
                              Allowed{wire::kStationEvents.name, parses<msg::StationEvent>},
                              Allowed{wire::kStationStats.name, parses<msg::StationStats>}};

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

}  // namespace telepalp::server
