#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/inside/held_probe.h"
#include "messages/inside.pb.h"
#include "proto/words/frames.h"

namespace telepalp::station {

/// What viewers draw of a scene's layers.
struct InnerSurfaces {
  msg::InnerStructures drawn;
  std::vector<std::string> left_out;  ///< layers that are not drawn: "layer liver: the solid has no bounds …"
};

/// The surfaces of the layers by dual contouring, thinned to one point in each cell of a grid; each point is then moved
/// onto the layer's surface. A layer's cells grow until it has at most its equal share of 36 000 points. A layer
/// without bounds or surface, or with too many points after six attempts, is left out. Blocks for up to some seconds.
[[nodiscard]] InnerSurfaces inner_structures(std::span<const scenes::SceneLayer> layers);

/// Sets the pose of H in the depth camera's frame: the points of `inside` are in H.
void set_place(msg::InnerStructures& inside, const Transform<HapticBase, DepthCamera>& haptic_from_camera);

/// The message of /station/ultrasound without an image, with the probe's pose if it is on the skin.
[[nodiscard]] msg::UltrasoundImage probe_message(const HeldProbe& probe, const ultrasound::BModeSettings& settings,
                                                 const Transform<HapticBase, DepthCamera>& haptic_from_camera);

/// Adds the image as JPEG and marks the probe as on the skin.
void set_image(msg::UltrasoundImage& message, const ultrasound::BModeImage& image);

}  // namespace telepalp::station
