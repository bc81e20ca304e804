#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>

#include "proto/wire/message.h"
#include "server/hub/rate_limit.h"

namespace telepalp::server {

/// Largest payload of a message from a peer: ten times that of half a second of ticks.
inline constexpr std::size_t kMaxUpstreamBytes = std::size_t{1} << 20;

/// The most that is read from a peer in a second, whatever it sends: four times what a station says.
inline constexpr std::size_t kMaxReadBytesPerSecond = std::size_t{2} << 20;

/// True if a peer may publish `topic`. Only the station's topics are allowed; only the server publishes camera, clock
/// and statistics.
[[nodiscard]] bool may_publish_upstream(const wire::Topic& topic) noexcept;

/// True if the topic of `message` is allowed and its payload parses as the topic's type. Otherwise every subscriber and
/// every recording would get an unreadable message.
[[nodiscard]] bool is_valid_upstream(const wire::Message& message);

/// How fast a peer may publish `topic`: over twice what a station does, with room for what waited through 2.5 s without
/// a network. `topic` may be published.
[[nodiscard]] Rate upstream_rate(const wire::Topic& topic);

/// Holds one peer to upstream_rate(), topic by topic.
class UpstreamRates {
 public:
  [[nodiscard]] bool passes(const wire::Message& message, RateLimiter::TimePoint now);

 private:
  std::map<std::string_view, RateLimiter> limiters_;  // by topic
};

/// `message` with `sender` as its field msg::Sender, whatever the peer wrote there.
[[nodiscard]] wire::Message with_sender(wire::Message message, std::uint32_t sender);

}  // namespace telepalp::server
