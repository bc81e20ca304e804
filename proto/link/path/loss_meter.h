#pragma once

#include <bitset>
#include <cstdint>

namespace telepalp::link {

/// Counts lost packets and loss bursts from the sequence numbers that arrive. A packet counts as lost when it is
/// missing while one that was sent kPatience packets later has arrived. The caller passes each number once.
class LossMeter {
 public:
  static constexpr std::uint64_t kPatience = 256;

  void received(std::uint64_t sequence) noexcept {
    if (sequence >= next_ + kSize) return skip_to(sequence);
    for (; next_ <= sequence; ++next_) {
      if (next_ >= kPatience) settle(next_ - kPatience);
      seen_[next_ % kSize] = false;
    }
    if (next_ - sequence <= kSize) seen_[sequence % kSize] = true;
  }
  [[nodiscard]] std::uint32_t settled() const noexcept { return settled_; }
  [[nodiscard]] std::uint32_t lost() const noexcept { return lost_; }
  [[nodiscard]] std::uint32_t bursts() const noexcept { return bursts_; }

 private:
  static constexpr std::uint64_t kSize = 4096;

  void settle(std::uint64_t sequence) noexcept {
    const bool lost = !seen_[sequence % kSize];
    ++settled_;
    if (lost) ++lost_;
    if (lost && !in_burst_) ++bursts_;
    in_burst_ = lost;
  }
  /// Call it after an outage: all packets that were on the way count as one burst.
  void skip_to(std::uint64_t sequence) noexcept {
    const auto gone = static_cast<std::uint32_t>(sequence - next_);
    settled_ += gone;
    lost_ += gone;
    ++bursts_;
    in_burst_ = false;
    seen_.set();
    next_ = sequence + 1;
  }

  std::bitset<kSize> seen_;
  std::uint64_t next_ = 0;
  std::uint32_t settled_ = 0;
  std::uint32_t lost_ = 0;
  std::uint32_t bursts_ = 0;
  bool in_burst_ = false;
};

}  // namespace telepalp::link
