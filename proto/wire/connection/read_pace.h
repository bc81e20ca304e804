#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace telepalp::wire {

/// The rate at which a peer is read. Bytes above it stay in the kernel's receive buffer, so that TCP's flow control
/// slows this peer alone. Pure.
class ReadPace {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `bytes_per_s` 0: no limit.
  explicit ReadPace(std::size_t bytes_per_s) noexcept : bytes_per_s_(bytes_per_s) {}

  /// When the next read may begin, after `bytes` were read at `now`; in the past: at once. Each read delays the next
  /// one in proportion to its bytes. A peer that was silent may first send as much as in two seconds.
  [[nodiscard]] Time next(std::size_t bytes, Time now) noexcept {
    if (bytes_per_s_ == 0) return {};
    constexpr std::chrono::seconds kBurst{2};
    const std::chrono::duration<double> cost(static_cast<double>(bytes) / static_cast<double>(bytes_per_s_));
    due_ = std::max(due_, now - kBurst) + std::chrono::duration_cast<Time::duration>(cost);
    return due_;
  }

 private:
  std::size_t bytes_per_s_;
  Time due_{};
};

}  // namespace telepalp::wire
