#pragma once

#include <optional>
#include <string>

#include "messages/viewer.pb.h"

namespace telepalp::wire {

/// The most that a /viewer/hand message weighs.
inline constexpr std::size_t kMaxViewerHandBytes = 128;

/// A viewer's hand from its bytes; nullopt when they are too many, no such message, or its place is missing, not finite
/// or further than 10 m from the camera.
[[nodiscard]] std::optional<msg::ViewerHand> read_viewer_hand(const std::string& payload);

}  // namespace telepalp::wire
