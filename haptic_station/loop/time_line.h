#pragma once

#include "proto/words/time.h"

namespace telepalp::loop {

/// Largest step back of the session clock within a session. Corrections below 1 s are slewed, so the clock itself does
/// not step back by less; but another thread may have read it a moment later than this tick.
inline constexpr std::chrono::milliseconds kSameSession{50};

/// True if the session clock, which read `latest` before, has stepped back to `now`: another session has begun, so that
/// no age can be computed from earlier times.
[[nodiscard]] constexpr bool begins_new_time_line(SessionTime now, SessionTime latest) noexcept {
  return now + kSameSession < latest;
}

}  // namespace telepalp::loop
