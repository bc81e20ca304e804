#pragma once

#include <optional>

#include "foxglove/FrameTransforms.pb.h"
#include "foxglove/SceneUpdate.pb.h"
#include "messages/station.pb.h"
#include "proto/words/time.h"

namespace telepalp::server {

/// The depth camera in the frame "patient_site", whose z points up when the camera looks down, and the station's hand,
/// proxy and device in the camera's frame; the camera alone without a `station`.
[[nodiscard]] foxglove::FrameTransforms transforms_view(const std::optional<msg::StationState>& station,
                                                        SessionTime now);

/// The hand, the device, the proxy and the force as an arrow of 2 cm for each newton, in the depth camera's frame.
/// Parts that the state does not tell are deleted, and all of it fades 1 s after the station's last word.
[[nodiscard]] foxglove::SceneUpdate scene_view(const msg::StationState& station);

}  // namespace telepalp::server
