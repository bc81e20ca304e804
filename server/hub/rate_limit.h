#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

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
      : rate_(rate), messages_(rate.burst_messages), bytes_(rate.burst_bytes) {}

  /// True if a message of `bytes` may pass at `now`; `now` must not decrease between calls.
  [[nodiscard]] bool passes(std::size_t bytes, TimePoint now) noexcept {
    refill(now);
    const auto size = static_cast<double>(bytes);
    if (messages_ < 1.0 || bytes_ < size) return false;
    messages_ -= 1.0;
    bytes_ -= size;
    return true;
  }

 private:
  void refill(TimePoint now) noexcept {
    const double elapsed_s = started_ ? std::chrono::duration<double>(now - last_).count() : 0.0;
    started_ = true;
    last_ = now;
    messages_ = std::min(rate_.burst_messages, messages_ + elapsed_s * rate_.messages_per_s);
    bytes_ = std::min(rate_.burst_bytes, bytes_ + elapsed_s * rate_.bytes_per_s);
  }

  Rate rate_;
  double messages_;
  double bytes_;
  TimePoint last_{};
  bool started_ = false;
};

}  // namespace telepalp::hub
