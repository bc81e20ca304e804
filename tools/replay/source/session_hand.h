#pragma once

#include <filesystem>

#include "proto/words/result.h"
#include "tools/replay/source/recorded_hand.h"

namespace telepalp::replay {

/// The positions of device and hand that a station published on /station/ticks, with times shifted so that the first
/// depth frame after a camera model was captured at kBegin, the start of a replay. Of several stations, the one with
/// the most ticks. Empty: no station was recorded. Error: not a session file, or damaged.
[[nodiscard]] Result<RecordedHand> read_session_hand(const std::filesystem::path& file);

}  // namespace telepalp::replay
