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

/// First text message of the Leap Motion service after connecting.
struct Hello {
  std::uint32_t version = 0;
  std::string service_version;
};

/// A hand in a frame.
struct Hand {
  std::int64_t id = 0;
  Point<HandTracker> palm;
  Vector<HandTracker> velocity;                     ///< [m/s]; zero if the text has none, or one beyond 100 m/s
  std::optional<Eigen::Quaterniond> attitude = {};  ///< from the hand's axes (hand_axes.h) to the tracker's frame
};

/// One frame of the tracker: the hands that the service sees, possibly none.
struct Frame {
  std::int64_t timestamp_us = 0;  ///< on the service's clock
  std::vector<Hand> hands;
  std::size_t refused = 0;  ///< hands left out: a coordinate is not finite, is beyond 10 m or is missing
};

/// A text that telepalp ignores, such as a device event.
struct Other {};

using Text = std::variant<Hello, Frame, Other>;

inline constexpr std::uint32_t kProtocolVersion = 6;
inline constexpr std::size_t kMostTextBytes = 256U << 10U;
inline constexpr std::size_t kMostHands = 16;

/// Parses one text of the service. Error: invalid JSON, over 256 KiB, a field of the wrong type, a time stamp beyond
/// 2^53 us, or over 16 hands. Numbers have a decimal point in every locale. A decimal comma breaks the JSON, or gives a
/// position too many coordinates: the text, or the hand, is refused.
[[nodiscard]] Result<Text> parse_text(std::string_view text);

/// Sent after connecting: asks for frames although the station has no window with the keyboard focus.
[[nodiscard]] inline std::string_view wish_for_background_frames() { return R"({"background":true})"; }

}  // namespace telepalp::tracking::leap
