#pragma once

namespace telepalp::server {

/// Least distance in frames from a key frame to a requested key frame. However many requests come, three of four frames
/// stay small predicted frames. A subscriber waits at most 0.13 s for its key frame, at 30 Hz.
inline constexpr int kFewestBetweenKeys = 4;

/// State that decides whether the next depth frame is a requested key frame.
struct KeyFramePacing {
  int since_key = 0;   ///< frames encoded since the last key frame
  bool asked = false;  ///< a key frame was requested and is not encoded yet
};

[[nodiscard]] constexpr bool key_is_due(const KeyFramePacing& pacing) noexcept {
  return pacing.asked && pacing.since_key + 1 >= kFewestBetweenKeys;
}

/// State after encoding a frame. A key frame, also one due by schedule, answers all earlier requests.
[[nodiscard]] constexpr KeyFramePacing after_frame(const KeyFramePacing& pacing, bool was_key) noexcept {
  return was_key ? KeyFramePacing{} : KeyFramePacing{.since_key = pacing.since_key + 1, .asked = pacing.asked};
}

}  // namespace telepalp::server
