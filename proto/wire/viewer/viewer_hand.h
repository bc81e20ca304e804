#pragma once

#include <optional>
#include <string>

#include "messages/viewer.pb.h"

namespace telepalp::wire {

/// Largest payload of a message on /viewer/hand.
inline constexpr std::size_t kMaxViewerHandBytes = 128;

/// Parses a message of /viewer/hand; nullopt when it is too large, is malformed, or its position is missing or has a
/// coordinate in the camera's frame that is not a number or beyond ±10 m. A message that asks to re-arm may have no
/// position.
[[nodiscard]] std::optional<msg::ViewerHand> read_viewer_hand(const std::string& payload);

}  // namespace telepalp::wire
