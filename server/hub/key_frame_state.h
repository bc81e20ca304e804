#pragma once

#include <cstdint>

#include "proto/words/time.h"

namespace telepalp::server {

// Some topics are sent in groups of pictures: a key frame, then frames that are each predicted from the one before.

/// Position of one subscriber in such a topic.
struct GroupPosition {
  std::uint64_t last = 0;  ///< sequence number of the newest queued message; 0: it needs a key frame
};

/// True when a subscriber at `place` can decode message `sequence`.
[[nodiscard]] constexpr bool can_use(const GroupPosition& place, std::uint64_t sequence, bool stands_alone) noexcept {
  return stands_alone || (place.last != 0 && sequence == place.last + 1);
}

/// State of a topic's key frames.
struct KeyFrameState {
  bool in_groups = false;  ///< a predicted frame has been published
  bool pending = false;    ///< a key frame was requested and has not come yet
  SessionTime last_key{};  ///< when the newest key frame was published
};

[[nodiscard]] constexpr KeyFrameState after_publishing(KeyFrameState wish, bool stands_alone,
                                                       SessionTime published) noexcept {
  if (!stands_alone) return {.in_groups = true, .pending = wish.pending, .last_key = wish.last_key};
  return {.in_groups = wish.in_groups, .pending = false, .last_key = published};
}

/// True while a subscriber that could not decode the message published at `unreadable` needs a key frame. False when a
/// key frame has been published since: it is on its way to the subscriber.
[[nodiscard]] constexpr bool still_lost(const KeyFrameState& wish, SessionTime unreadable) noexcept {
  return unreadable > wish.last_key;
}

}  // namespace telepalp::server
