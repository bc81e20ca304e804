#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/inside/held_probe.h"
#include "messages/inside.pb.h"
#include "proto/words/frames.h"

namespace telepalp::station {

/// The surfaces of the layers by marching cubes, thinned to one point for each place of a grid and moved onto the true
/// surface: at most 36 000 points in all, and the grid is as wide as that needs. A layer without bounds is left out.
/// Takes up to some seconds.
[[nodiscard]] msg::InnerStructures inner_structures(std::span<const scenes::SceneLayer> layers);

/// Says where H is: the structures are displayed there.
void set_place(msg::InnerStructures& inside, const Transform<HapticBase, DepthCamera>& haptic_from_camera);

/// The message of /station/ultrasound without an image, with the probe's pose.
[[nodiscard]] msg::UltrasoundImage probe_message(const HeldProbe& probe, const ultrasound::BModeSettings& settings,
                                                 const Transform<HapticBase, DepthCamera>& haptic_from_camera);

/// Adds the image as JPEG.
void set_image(msg::UltrasoundImage& message, const ultrasound::BModeImage& image);

}  // namespace telepalp::station
