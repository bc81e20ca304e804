#pragma once

#include <ctime>

namespace telepalp::bench {

/// Processor time of this thread [us].
inline double thread_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

}  // namespace telepalp::bench
