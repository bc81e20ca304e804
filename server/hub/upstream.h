#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>

#include "proto/wire/message.h"
#include "server/hub/rate_limit.h"

namespace telepalp::hub {

/// Largest payload of a message from a peer: ten times the size of half a second of ticks (records of the 2 kHz loop).
inline constexpr std::size_t kMaxUpstreamBytes = std::size_t{1} << 20;

/// Largest number of bytes that the server reads from a peer in a second: twice what a station with an ultrasound
/// probe sends.
inline constexpr std::size_t kMaxReadBytesPerSecond = std::size_t{2} << 20;

/// True if a peer may publish `topic`.
[[nodiscard]] constexpr bool may_publish_upstream(const wire::Topic& topic) noexcept {
  return topic.publisher == wire::Publisher::Station;
}

/// True if a peer may publish the topic of `message`, its payload is at most kMaxUpstreamBytes and parses as the
/// topic's type, and the values of an ultrasound image, of structures inside the body, or of a window are valid
/// (wire::is_valid()).
/// If the server passed on other messages, every subscriber and every recording would get an unreadable message.
[[nodiscard]] bool is_valid_upstream(const wire::Message& message);

/// The largest rate at which a peer may publish `topic`: Topic::most_from_peer, with a burst for the messages that
/// queue during 2.5 s without a network. `topic` is one that a peer may publish.
[[nodiscard]] Rate upstream_rate(const wire::Topic& topic);

/// Limits one peer to upstream_rate() on each topic.
class UpstreamRates {
 public:
  [[nodiscard]] bool passes(const wire::Message& message, RateLimiter::TimePoint now);

 private:
  std::map<std::string_view, RateLimiter> limiters_;  // by topic
};

/// `message` with its field msg::Sender set to `sender`; a value that the peer wrote is replaced.
[[nodiscard]] wire::Message with_sender(wire::Message message, std::uint32_t sender);

}  // namespace telepalp::hub
