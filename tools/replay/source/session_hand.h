#pragma once

#include <filesystem>

#include "proto/words/result.h"
#include "tools/replay/source/recorded_hand.h"

namespace telepalp::replay {

/// The device and the hand that a station published on /station/ticks, in the replay's session time: the session's
/// first depth frame with a camera model is at kBegin. Of several stations, the one with the most ticks. Empty: no
/// station was recorded. Error: not a session file, or damaged.
[[nodiscard]] Result<RecordedHand> read_session_hand(const std::filesystem::path& file);

}  // namespace telepalp::replay
