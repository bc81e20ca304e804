#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::tracking::leap {

/// The service's first text.
struct Hello {
  std::uint32_t version = 0;
  std::string service_version;
};

/// A hand in a frame.
struct Hand {
  std::int64_t id = 0;
  Point<HandTracker> palm;
  Vector<HandTracker> velocity;  ///< [m/s]; zero when the text has none
};

/// One frame: all hands that the service sees, possibly none.
struct Frame {
  std::int64_t timestamp_us = 0;  ///< of the service's own clock
  std::vector<Hand> hands;
  std::size_t refused = 0;  ///< hands left out: not finite, further than 10 m, not three coordinates
};

/// A text that concerns nobody here, such as a device event.
struct Other {};

using Text = std::variant<Hello, Frame, Other>;

inline constexpr std::uint32_t kProtocolVersion = 6;
inline constexpr std::size_t kMostTextBytes = 256U << 10U;
inline constexpr std::size_t kMostHands = 16;

/// Reads one text of the service. Error: no JSON, over 256 KiB, a field of the wrong type. Numbers use a point
/// whatever the locale: a decimal comma either breaks the JSON or makes coordinates too many, and is refused.
[[nodiscard]] Result<Text> parse_text(std::string_view text);

/// What we send after connecting: frames are wanted although no window of ours has the focus.
[[nodiscard]] inline std::string_view wish_for_background_frames() { return R"({"background":true})"; }

}  // namespace telepalp::tracking::leap
