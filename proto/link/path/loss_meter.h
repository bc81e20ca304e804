#pragma once

#include <bitset>
#include <cstdint>

#include "proto/words/time.h"

namespace telepalp::link {

/// Counts lost packets and loss bursts from the sequence numbers that arrive. Missing packet n counts as lost when
/// packet n + kPatience or a later one arrived at least kOvertaking ago, or when a packet with a number of at least
/// n + kMostWaiting has arrived. The caller passes each number once.
class LossMeter {
 public:
  static constexpr std::uint64_t kPatience = 256;
  /// Bound on reordering by jitter: a packet may overtake packets that were sent up to this much earlier.
  static constexpr Nanoseconds kOvertaking = std::chrono::milliseconds(150);
  static constexpr std::uint64_t kMostWaiting = 8192;

  void received(std::uint64_t sequence, SessionTime now) noexcept {
    if (sequence >= next_ + kSize) return skip_to(sequence, now);
    for (; next_ <= sequence; ++next_) seen_[next_ % kSize] = false;
    if (next_ - sequence <= kSize) seen_[sequence % kSize] = true;
    // Packet mark_ - 1 arrived at least kOvertaking ago, and each packet below it was sent earlier.
    if (now - mark_at_ >= kOvertaking) {
      overtaken_ = mark_;
      mark_ = next_;
      mark_at_ = now;
    }
    while (settling_ + kPatience < next_ && (settling_ + kPatience < overtaken_ || settling_ + kMostWaiting < next_))
      settle(settling_++);
  }
  /// Number of packets that have arrived or count as lost.
  [[nodiscard]] std::uint32_t settled() const noexcept { return settled_; }
  [[nodiscard]] std::uint32_t lost() const noexcept { return lost_; }
  [[nodiscard]] std::uint32_t bursts() const noexcept { return bursts_; }

 private:
  static constexpr std::uint64_t kSize = 16'384;

  void settle(std::uint64_t sequence) noexcept {
    const bool lost = !seen_[sequence % kSize];
    ++settled_;
    if (lost) ++lost_;
    if (lost && !in_burst_) ++bursts_;
    in_burst_ = lost;
  }
  /// Continues at `sequence` after an outage: all packets in between count as lost, in one burst.
  void skip_to(std::uint64_t sequence, SessionTime now) noexcept {
    while (settling_ < next_) settle(settling_++);
    const auto gone = static_cast<std::uint32_t>(sequence - next_);
    settled_ += gone;
    lost_ += gone;
    ++bursts_;
    in_burst_ = false;
    next_ = settling_ = sequence + 1;
    mark_ = overtaken_ = next_;
    mark_at_ = now;
  }

  std::bitset<kSize> seen_;
  std::uint64_t next_ = 0;       ///< one more than the highest number received
  std::uint64_t settling_ = 0;   ///< the lowest number that counts neither as arrived nor as lost yet
  std::uint64_t mark_ = 0;       ///< value that next_ had at mark_at_
  std::uint64_t overtaken_ = 0;  ///< value that next_ had at least kOvertaking ago
  SessionTime mark_at_{};
  std::uint32_t settled_ = 0;
  std::uint32_t lost_ = 0;
  std::uint32_t bursts_ = 0;
  bool in_burst_ = false;
};

}  // namespace telepalp::link
