#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>

#include "proto/wire/clock_sync.h"
#include "proto/wire/session_clock.h"

namespace telepalp::wire {

/// The session clock as a client estimates it, readable on each thread. Before the first sample it is this machine's
/// wall clock. Owner: the link's thread, which adds samples.
class LinkClock {
 public:
  /// The present estimate. Any thread. Call it for each reading, because the offset is slewed.
  [[nodiscard]] SessionClock clock() const noexcept {
    const Nanoseconds target{target_ns_.load(std::memory_order_acquire)};
    const Nanoseconds line_at_zero{line_at_zero_ns_.load(std::memory_order_acquire)};
    return SessionClock{SlewedOffset{.target = target, .line_at_zero = line_at_zero}.at(local_now())};
  }
  /// Bound on the error of clock() now; Nanoseconds::max() without a sample.
  [[nodiscard]] Nanoseconds uncertainty() const noexcept { return sync_.uncertainty(local_now()); }
  [[nodiscard]] Nanoseconds stepped() const noexcept { return sync_.stepped(); }  ///< ClockSync::stepped()

  /// False: the sample is inconsistent, and is dropped.
  bool add(const ClockSample& sample) {
    if (!sync_.add(sample)) return false;
    // With this order, a reader between the two stores still sees the old target, or a line that is not above the old
    // offset.
    line_at_zero_ns_.store(sync_.offset()->line_at_zero.count(), std::memory_order_release);
    target_ns_.store(sync_.offset()->target.count(), std::memory_order_release);
    return true;
  }
  void forget_samples() noexcept { sync_.forget_samples(); }

 private:
  static Nanoseconds local_now() noexcept { return std::chrono::steady_clock::now().time_since_epoch(); }

  ClockSync sync_;
  std::atomic<std::int64_t> target_ns_{
      SessionClock::anchored_to_wall_clock().offset().count()};  // SlewedOffset::target; stored last
  std::atomic<std::int64_t> line_at_zero_ns_{std::numeric_limits<std::int64_t>::min() /
                                             2};  // SlewedOffset::line_at_zero; readers load it last
};

}  // namespace telepalp::wire
