#pragma once

namespace telepalp::server {

/// From one key frame to one that somebody asked for: whoever asks, and however often, three of four frames stay
/// small. Who lost its place waits 0.13 s for it at most, at 30 Hz.
inline constexpr int kFewestBetweenKeys = 4;

/// What decides whether the next depth frame is a key frame because somebody asked.
struct KeyFramePacing {
  int since_key = 0;   ///< frames encoded since the last key frame
  bool asked = false;  ///< and not made yet
};

[[nodiscard]] constexpr bool key_is_due(const KeyFramePacing& pacing) noexcept {
  return pacing.asked && pacing.since_key + 1 >= kFewestBetweenKeys;
}

/// A key frame serves whoever asked before it, whatever it was made for.
[[nodiscard]] constexpr KeyFramePacing after_frame(const KeyFramePacing& pacing, bool was_key) noexcept {
  return was_key ? KeyFramePacing{} : KeyFramePacing{.since_key = pacing.since_key + 1, .asked = pacing.asked};
}

}  // namespace telepalp::server
