#pragma once

#include <bitset>
#include <cstdint>

namespace telepalp::link {

/// Remembers which sequence numbers were received (RFC 4303 §3.4.3). Call accept() only for authenticated packets: a
/// forged sequence number must not move the window.
class ReplayWindow {
 public:
  /// Number of later packets that may overtake a packet: those of one second at 4000 packets/s.
  static constexpr std::uint64_t kSize = 4096;

  /// False: `sequence` was received before, or is older than the window.
  [[nodiscard]] bool would_accept(std::uint64_t sequence) const noexcept {
    if (sequence >= next_) return sequence != UINT64_MAX;  // next_ would start again at 0
    return next_ - sequence <= kSize && !seen_[sequence % kSize];
  }
  void accept(std::uint64_t sequence) noexcept {
    if (sequence >= next_ + kSize)
      seen_.reset();
    else
      for (; next_ < sequence; ++next_) seen_[next_ % kSize] = false;
    if (sequence >= next_) next_ = sequence + 1;
    seen_[sequence % kSize] = true;
  }
  /// One more than the highest sequence number received.
  [[nodiscard]] std::uint64_t next() const noexcept { return next_; }

 private:
  std::uint64_t next_ = 0;
  std::bitset<kSize> seen_;
};

}  // namespace telepalp::link
