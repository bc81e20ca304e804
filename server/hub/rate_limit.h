#pragma once

#include <chrono>
#include <cstddef>

#include "server/access/token_bucket.h"

namespace telepalp::hub {

/// Average rate and burst size of messages and bytes.
struct Rate {
  double messages_per_s;
  double bytes_per_s;
  double burst_messages;
  double burst_bytes;
};

/// A token bucket for messages and one for bytes: a message passes when both hold enough. Pure: time is an argument.
class RateLimiter {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  explicit RateLimiter(const Rate& rate) noexcept
      : messages_(rate.messages_per_s, rate.burst_messages), bytes_(rate.bytes_per_s, rate.burst_bytes) {}

  /// True if a message of `bytes` may pass at `now`; `now` must not decrease between calls.
  [[nodiscard]] bool passes(std::size_t bytes, TimePoint now) noexcept {
    const auto size = static_cast<double>(bytes);
    const bool has_message = messages_.has(1.0, now.time_since_epoch());
    if (!bytes_.has(size, now.time_since_epoch()) || !has_message) return false;
    messages_.spend(1.0);
    bytes_.spend(size);
    return true;
  }

 private:
  access::TokenBucket messages_;
  access::TokenBucket bytes_;
};

}  // namespace telepalp::hub
