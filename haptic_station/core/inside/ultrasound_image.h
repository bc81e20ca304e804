#pragma once

#include "haptic_station/core/inside/held_probe.h"
#include "messages/inside.pb.h"

namespace telepalp::core {

/// The message of /station/ultrasound without an image, with the probe's pose if it is on the skin.
[[nodiscard]] msg::UltrasoundImage probe_message(const HeldProbe& probe, const ultrasound::BModeSettings& settings,
                                                 const Transform<HapticBase, DepthCamera>& haptic_from_camera);

/// Adds the image as JPEG and marks the probe as on the skin.
void set_image(msg::UltrasoundImage& message, const ultrasound::BModeImage& image);

}  // namespace telepalp::core
