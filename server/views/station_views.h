#pragma once

#include <optional>

#include "foxglove/CompressedImage.pb.h"
#include "foxglove/FrameTransforms.pb.h"
#include "foxglove/KeyValuePair.pb.h"
#include "foxglove/PoseInFrame.pb.h"
#include "foxglove/SceneUpdate.pb.h"
#include "messages/inside.pb.h"
#include "messages/station.pb.h"
#include "proto/words/time.h"

namespace telepalp::views {

/// Transforms of the depth camera in the frame "patient_site", whose z axis points up when the camera looks down, and
/// of the station's hand, proxy and device in the camera's frame. Without a `station`, only the camera.
[[nodiscard]] foxglove::FrameTransforms transforms_view(const std::optional<msg::StationState>& station,
                                                        SessionTime now);

/// Hand, device and proxy, the force of contact as an arrow and the phase in words, in the depth camera's frame, in the
/// sizes of proto/words/drawn_sizes.h. Parts without a value in `station` are deleted, and so is the arrow while the
/// device is driven; all parts disappear 1 s after the station's last message.
[[nodiscard]] foxglove::SceneUpdate scene_view(const msg::StationState& station);

/// The displayed hand with its attitude, in the depth camera's frame; nullopt while the station has no hand.
[[nodiscard]] std::optional<foxglove::PoseInFrame> hand_view(const msg::StationState& station);

/// The phase in a doctor's words, for a panel of states: the key is "phase", the value "Above the skin".
[[nodiscard]] foxglove::KeyValuePair phase_view(const msg::StationState& station);

/// The image under the station's ultrasound probe, in the frame "probe"; nullopt while the probe is not on the skin.
[[nodiscard]] std::optional<foxglove::CompressedImage> ultrasound_view(const msg::UltrasoundImage& image);

}  // namespace telepalp::views
