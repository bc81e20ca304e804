#pragma once

#include <optional>
#include <string>

#include "messages/viewer.pb.h"

namespace telepalp::wire {

/// Largest payload of a message on /viewer/hand.
inline constexpr std::size_t kMaxViewerHandBytes = 128;

/// Parses a message of /viewer/hand; nullopt when it is too large, is malformed, or its position is missing, not finite
/// or more than 10 m from the camera.
[[nodiscard]] std::optional<msg::ViewerHand> read_viewer_hand(const std::string& payload);

}  // namespace telepalp::wire
