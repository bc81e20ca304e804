#pragma once

#include <ctime>

namespace telepalp::bench {

/// Reading of one of the system's clocks [us].
[[nodiscard]] inline double clock_us(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

/// Processor time of this thread [us]. A busy machine does not lengthen it as it does wall time.
[[nodiscard]] inline double thread_us() { return clock_us(CLOCK_THREAD_CPUTIME_ID); }

/// Processor time of all threads of this process [us].
[[nodiscard]] inline double process_us() { return clock_us(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace telepalp::bench
