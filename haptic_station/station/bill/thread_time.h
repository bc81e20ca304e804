#pragma once

#include <ctime>

#include "proto/words/time.h"

namespace telepalp::station {

/// Processor time of the calling thread since its start [ns].
[[nodiscard]] inline std::int64_t thread_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

}  // namespace telepalp::station
