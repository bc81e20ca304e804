#include "proto/wire/session_clock.h"

namespace telepalp::wire {

SessionClock SessionClock::anchored_to_wall_clock() {
  const auto wall = std::chrono::system_clock::now().time_since_epoch();
  const auto steady = std::chrono::steady_clock::now().time_since_epoch();
  return SessionClock{std::chrono::duration_cast<Nanoseconds>(wall - steady)};
}

SessionTime SessionClock::now() const noexcept {
  return SessionTime{std::chrono::steady_clock::now().time_since_epoch() + offset_};
}

std::chrono::steady_clock::time_point SessionClock::steady(SessionTime at) const noexcept {
  return std::chrono::steady_clock::time_point{at.time_since_epoch() - offset_};
}

}  // namespace telepalp::wire
