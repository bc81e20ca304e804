#pragma once

#include <chrono>

#include "haptic_station/station/threads/realtime.h"
#include "messages/station.pb.h"

namespace telepalp::station {

/// How long the timer is watched before a run.
inline constexpr std::chrono::milliseconds kTimerWatched{1000};

/// How late this computer wakes a thread that only waits, 2000 times a second for `length`: what no program on it can
/// better. With real-time priority where that is granted, as the haptic thread has. Blocks for `length`.
[[nodiscard]] msg::TimerCheck watch_idle_timer(std::chrono::milliseconds length);

/// "3 of 2000 wake-ups of this computer's idle timer were missed, late 62 us at the median and 4100 us at most"
[[nodiscard]] std::string in_words(const msg::TimerCheck& check);

}  // namespace telepalp::station
