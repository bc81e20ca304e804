#pragma once

#include <algorithm>
#include <ctime>

#include "proto/words/time.h"

namespace telepalp::station {

/// Processor time of the calling thread since its start [ns].
[[nodiscard]] inline std::int64_t thread_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

/// Processor time of one call of thread_ns() [ns]. It costs as much as a quiet tick, so that each short step that is
/// measured with it must be shortened by it.
[[nodiscard]] inline std::int64_t thread_clock_ns() noexcept {
  static const std::int64_t kCost = [] {
    std::int64_t least = 1'000'000;
    for (int i = 0; i < 200; ++i) {
      const std::int64_t before = thread_ns();
      least = std::min(least, thread_ns() - before);
    }
    return least;
  }();
  return kCost;
}

}  // namespace telepalp::station
