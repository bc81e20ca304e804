#pragma once

#include <chrono>
#include <cstdint>

namespace telepalp {

/// Clock type of session time: nanoseconds, monotonic, equal at the patient's and the doctor's site once the clocks are
/// synchronised. It has no now(), so that pure code cannot read a clock; SessionClock in proto/wire/session_clock.h
/// reads it.
struct SessionEpoch {
  using rep = std::int64_t;
  using period = std::nano;
  using duration = std::chrono::nanoseconds;
  using time_point = std::chrono::time_point<SessionEpoch>;
  static constexpr bool is_steady = true;
};

using Nanoseconds = std::chrono::nanoseconds;
using SessionTime = SessionEpoch::time_point;

[[nodiscard]] constexpr double to_seconds(Nanoseconds span) noexcept {
  return std::chrono::duration<double>(span).count();
}
[[nodiscard]] constexpr double to_milliseconds(Nanoseconds span) noexcept {
  return std::chrono::duration<double, std::milli>(span).count();
}
[[nodiscard]] constexpr Nanoseconds from_seconds(double seconds) noexcept {
  return std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(seconds));
}
[[nodiscard]] constexpr std::int64_t to_nanoseconds(SessionTime at) noexcept { return at.time_since_epoch().count(); }
[[nodiscard]] constexpr SessionTime session_time(std::int64_t nanoseconds) noexcept {
  return SessionTime{Nanoseconds{nanoseconds}};
}

}  // namespace telepalp
