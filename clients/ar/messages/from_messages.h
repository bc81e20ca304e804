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

/// True if the state has a position of the device point in front of the camera.
[[nodiscard]] bool is_drawable(const msg::StationState& state);

/// The touch to draw. The device point replaces a missing proxy, and the proxy replaces a missing hand. Call touch_of()
/// only for a state for which is_drawable() is true.
[[nodiscard]] Touch touch_of(const msg::StationState& state);

/// Lines of the panel: state, force of contact or of the drive, indentation, age of the surface, and the time since
/// `start_ns` (session time), if given.
[[nodiscard]] std::vector<PanelLine> panel_of(const msg::StationState& state,
                                              std::optional<std::int64_t> start_ns = std::nullopt);

}  // namespace telepalp::ar
