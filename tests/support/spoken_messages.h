#pragma once

#include <cstdint>
#include <vector>

#include "proto/wire/message.h"
#include "proto/wire/topics.h"

namespace telepalp::support {

/// What a page publishes while its microphone is open for the frames `from` to `until` - 1 of speech(): one message for
/// each frame, when the frame has been said. Frame 0 begins at `begin`; by `talker`.
[[nodiscard]] std::vector<wire::Message> spoken_messages(const wire::Topic& topic, SessionTime begin,
                                                         std::uint32_t from, std::uint32_t until,
                                                         std::uint64_t talker = 1);

}  // namespace telepalp::support
