#include "haptic_station/station/threads/cost_clock.h"

#include <chrono>
#include <thread>

#if defined(__x86_64__)
#include <x86intrin.h>
#endif

namespace telepalp::station {

std::uint64_t cycles_now() noexcept {
#if defined(__x86_64__)
  return __rdtsc();
#else
  return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
}

double cycles_per_us() {
  static const double kRate = [] {
    const auto began = std::chrono::steady_clock::now();
    const std::uint64_t first = cycles_now();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const double us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - began).count();
    return static_cast<double>(cycles_now() - first) / us;
  }();
  return kRate;
}

}  // namespace telepalp::station
