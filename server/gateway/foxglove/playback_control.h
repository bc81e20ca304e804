#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "messages/playback.pb.h"
#include "proto/words/result.h"

namespace telepalp::gateway::foxglove {

/// A client's request of Foxglove's capability "playbackControl". Binary, little-endian: 03 | u8 command: 0 play, 1
/// pause | f32 speed | u8: not 0 to seek | u64 time to seek to [ns] | u32 length of the id | id of the request.
struct PlaybackRequest {
  bool play = false;
  double speed = 1.0;
  std::optional<std::uint64_t> seek_ns;  ///< session time of the recording
  std::string id;
};

/// True if the client's binary message is a playback request, well formed or not.
[[nodiscard]] bool is_playback_request(std::string_view bytes) noexcept;

/// Parses a playback request. Error: a wrong length, an unknown command, a speed that is not finite, or a time outside
/// the session of `state`.
[[nodiscard]] Result<PlaybackRequest> read_playback_request(std::string_view bytes, const msg::PlaybackState& state);

/// The request as a command to the player.
[[nodiscard]] msg::PlaybackCommand command_of(const PlaybackRequest& request, const msg::PlaybackState& state);

/// The state as a binary message: 05 | u8 status: 0 playing, 1 paused, 3 ended | u64 recorded session time [ns] | f32
/// speed | u8 whether a seek was done: 0 here | u32 length of the id: 0 here | id of the answered request.
[[nodiscard]] std::string playback_state(const msg::PlaybackState& state);

/// The reply to `request`: as playback_state(), for the state to which `request` leads from `state`, with the id.
[[nodiscard]] std::string playback_reply(const msg::PlaybackState& state, const PlaybackRequest& request);

/// Session time of the recording's last message [ns].
[[nodiscard]] std::uint64_t end_ns(const msg::PlaybackState& state) noexcept;

}  // namespace telepalp::gateway::foxglove
