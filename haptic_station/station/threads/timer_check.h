#pragma once

#include <chrono>

#include "haptic_station/station/threads/realtime.h"
#include "messages/station.pb.h"

namespace telepalp::station {

/// `length` of watch_idle_timer() before a run.
inline constexpr std::chrono::milliseconds kTimerWatched{1000};

/// Measures how late this computer wakes a thread that only waits, 2000 times a second for `length`: the haptic thread
/// cannot be more punctual. Like the haptic thread, the measuring thread has real-time priority if it is granted.
/// Blocks for `length`.
[[nodiscard]] msg::TimerCheck watch_idle_timer(std::chrono::milliseconds length);

/// As text: "timer of this computer at 2 kHz, while idle: 3 of 2000 wake-ups missed; delay: median 62 us, largest
/// 4100 us"
[[nodiscard]] std::string in_words(const msg::TimerCheck& check);

}  // namespace telepalp::station
