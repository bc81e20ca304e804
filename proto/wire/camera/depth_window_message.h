#pragma once

#include <optional>

#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/words/depth/depth_window.h"

namespace telepalp::wire {

[[nodiscard]] msg::DepthWindow to_message(const DepthWindow& window);

/// The window of a message. nullopt: it is not well formed for any image, as its sides are not 1 to kMaxImageSide, it
/// begins left of or above the image, or its bounds are not numbers from 0 to 1 that do not shrink towards the border.
[[nodiscard]] std::optional<DepthWindow> window_of(const msg::DepthWindow& window) noexcept;

/// True if the requested window is well formed for some image.
[[nodiscard]] bool is_valid(const msg::WindowRequest& request) noexcept;

}  // namespace telepalp::wire
