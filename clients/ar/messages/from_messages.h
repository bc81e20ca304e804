#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clients/ar/augmented_view.h"
#include "messages/station.pb.h"

namespace telepalp::ar {

/// The intrinsics `camera` rescaled to an image of `width` × `height`; pixel centres have integer coordinates.
[[nodiscard]] Intrinsics scaled_to(const Intrinsics& camera, int width, int height);

/// True once the station knows the position of its hand in the camera's frame.
[[nodiscard]] bool is_drawable(const msg::StationState& state);

/// The touch to draw. Call it only for a state for which is_drawable() is true.
[[nodiscard]] Touch touch_of(const msg::StationState& state);

/// Lines of the panel: state, force, indentation, age of the surface, and the time since `start_ns` (session time), if
/// given.
[[nodiscard]] std::vector<PanelLine> panel_of(const msg::StationState& state,
                                              std::optional<std::int64_t> start_ns = std::nullopt);

}  // namespace telepalp::ar
