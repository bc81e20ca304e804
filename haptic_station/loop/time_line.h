#pragma once

#include "proto/words/time.h"

namespace telepalp::loop {

/// Largest step back of the session clock within a session: smaller corrections are slewed, and a tick may read the
/// clock a moment before another thread.
inline constexpr std::chrono::milliseconds kSameSession{50};

/// True if the session clock, which read `latest` before, has stepped back to `now`: another session has begun, so that
/// no age can be computed from earlier times.
[[nodiscard]] constexpr bool begins_new_time_line(SessionTime now, SessionTime latest) noexcept {
  return now + kSameSession < latest;
}

}  // namespace telepalp::loop
