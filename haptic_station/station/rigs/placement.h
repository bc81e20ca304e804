#pragma once

#include <optional>

#include "haptic_station/scenes/scene.h"
#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::station {

/// The surface point under the middle of the image: on the central ray, at the median depth of the smallest centred
/// window in which at least half of the pixels are measured. nullopt when no such window is within the image.
[[nodiscard]] std::optional<Point<DepthCamera>> point_under_center(const DepthImage& depth, const Intrinsics& camera);

/// `haptic_from_camera` shifted, not turned, so that `skin` (a point of the patient's surface, such as the one under
/// the image centre) becomes the origin of the haptic base's frame H. A scene made for one camera height then works at
/// any height.
[[nodiscard]] Transform<HapticBase, DepthCamera> centered_on(
    const Transform<HapticBase, DepthCamera>& haptic_from_camera, const Point<DepthCamera>& skin) noexcept;

/// The transform haptic_from_camera of the scene, or, where the scene asks for centring, the one centred on the visible
/// skin. nullopt: centring is asked for, and the middle of the image has no measured depth.
[[nodiscard]] std::optional<Transform<HapticBase, DepthCamera>> placed(const scenes::Scene& scene,
                                                                       const DepthImage& depth,
                                                                       const Intrinsics& camera);

}  // namespace telepalp::station
