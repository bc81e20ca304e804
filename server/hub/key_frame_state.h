#pragma once

#include <cstdint>

#include "proto/words/time.h"

namespace telepalp::server {

// Some topics come in groups: a key message that stands alone, then messages that each depend on the one before.

/// How far one subscriber has followed such a topic.
struct GroupPosition {
  std::uint64_t last = 0;  ///< number of the newest message that was put in its queue; 0: it has lost its place
};

/// Whether a subscriber at `place` can make anything of message `sequence`.
[[nodiscard]] constexpr bool can_use(const GroupPosition& place, std::uint64_t sequence, bool stands_alone) noexcept {
  return stands_alone || (place.last != 0 && sequence == place.last + 1);
}

/// What is known of a topic's key messages.
struct KeyFrameState {
  bool in_groups = false;  ///< a message that depends on another has been published
  bool pending = false;    ///< the publisher was asked for a key message, and none has come since
  SessionTime last_key{};  ///< when the newest was published
};

[[nodiscard]] constexpr KeyFrameState after_publishing(KeyFrameState wish, bool stands_alone,
                                                       SessionTime published) noexcept {
  if (!stands_alone) return {.in_groups = true, .pending = wish.pending, .last_key = wish.last_key};
  return {.in_groups = wish.in_groups, .pending = false, .last_key = published};
}

/// Whether who could not read what was published at `unreadable` still lacks something: a key message published later
/// is on its way to it.
[[nodiscard]] constexpr bool still_lost(const KeyFrameState& wish, SessionTime unreadable) noexcept {
  return unreadable > wish.last_key;
}

}  // namespace telepalp::server
