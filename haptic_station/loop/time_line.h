#pragma once

#include "proto/words/time.h"

namespace telepalp::loop {

/// Margin for comparing times of the session clock that different threads read at slightly different instants. A larger
/// step back is a new session: the clock never steps back by less than 1 s, because smaller corrections are slewed.
inline constexpr std::chrono::milliseconds kSameSession{50};

/// True if the session clock, which read `latest` before, has stepped back to `now`: another session has begun, so that
/// no age can be computed from earlier times.
[[nodiscard]] constexpr bool begins_new_time_line(SessionTime now, SessionTime latest) noexcept {
  return now + kSameSession < latest;
}

}  // namespace telepalp::loop
