#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "proto/words/time.h"

namespace telepalp::wire {

// The messages of some topics come in groups of pictures: a key frame, then frames that are each predicted from the one
// before. A receiver that lacks a reference frame requests a key frame. The request goes from the receiver
// (KeyFrameRequest) to the server's distributor of messages, the hub (KeyFrameState), and from the hub to the encoder
// (KeyFramePacing). Each of the three passes on only some of the requests that it gets.

/// Decides when a receiver that cannot decode requests a key frame: at the first failure, then at a fixed interval
/// while decoding still fails.
class KeyFrameRequest {
 public:
  /// Time between requests: a key frame may be three frames away, and then needs one network delay to arrive.
  static constexpr Nanoseconds kInterval = std::chrono::milliseconds(300);

  /// A frame could not be decoded at `now`. Returns true when a request is due.
  [[nodiscard]] bool failed(SessionTime now) noexcept {
    if (requested_ && now - *requested_ < kInterval && now >= *requested_) return false;
    requested_ = now;
    return true;
  }
  void succeeded() noexcept { requested_.reset(); }

 private:
  std::optional<SessionTime> requested_;
};

/// Position of one of the hub's subscribers in a topic with groups.
struct GroupPosition {
  std::uint64_t last = 0;  ///< sequence number of the newest queued message; 0: the subscriber needs a key frame
};

/// True when a subscriber at `position` can decode message `sequence`.
[[nodiscard]] constexpr bool can_decode(const GroupPosition& position, std::uint64_t sequence,
                                        bool key_frame) noexcept {
  return key_frame || (position.last != 0 && sequence == position.last + 1);
}

/// The hub's state about the key frames of one topic.
struct KeyFrameState {
  bool in_groups = false;         ///< a predicted frame has been published
  bool requested = false;         ///< a key frame was requested and is not published yet
  SessionTime last_key_frame{};   ///< when the newest key frame was published
  std::uint64_t last_number = 0;  ///< number that the newest message came with; 0: it had none
};

/// `number`: that with which the message came to the hub; 0: none, because it comes from the encoder, without a loss.
[[nodiscard]] constexpr KeyFrameState after_publishing(const KeyFrameState& state, bool key_frame,
                                                       SessionTime published, std::uint64_t number = 0) noexcept {
  return {.in_groups = state.in_groups || !key_frame,
          .requested = state.requested && !key_frame,
          .last_key_frame = key_frame ? published : state.last_key_frame,
          .last_number = number};
}

/// True if the message before this predicted one did not come to the hub.
[[nodiscard]] constexpr bool lacks_reference(const KeyFrameState& state, std::uint64_t number,
                                             bool key_frame) noexcept {
  return !key_frame && number != 0 && number != state.last_number + 1;
}

/// True while a subscriber that could not decode the message published at `undecodable` needs a key frame. False when a
/// key frame has been published since: it is on its way to the subscriber.
[[nodiscard]] constexpr bool still_needs_key_frame(const KeyFrameState& state, SessionTime undecodable) noexcept {
  return undecodable > state.last_key_frame;
}

/// Least distance in frames from a key frame to a requested key frame. At any rate of requests, at least three of four
/// frames are small predicted frames. At 30 Hz the encoder makes a requested key frame within 0.13 s.
inline constexpr int kMinKeyFrameDistance = 4;

/// State that decides whether the next frame of the encoder is a requested key frame.
struct KeyFramePacing {
  int since_key_frame = 0;  ///< frames encoded since the last key frame
  bool requested = false;   ///< a key frame was requested and is not encoded yet
};

[[nodiscard]] constexpr bool key_frame_is_due(const KeyFramePacing& pacing) noexcept {
  return pacing.requested && pacing.since_key_frame + 1 >= kMinKeyFrameDistance;
}

/// State after encoding a frame. A key frame, also one due by schedule, answers all earlier requests.
[[nodiscard]] constexpr KeyFramePacing after_encoding(const KeyFramePacing& pacing, bool key_frame) noexcept {
  if (key_frame) return {};
  return {.since_key_frame = pacing.since_key_frame + 1, .requested = pacing.requested};
}

}  // namespace telepalp::wire
