#pragma once

#include <optional>

#include "haptic_station/scenes/scene.h"
#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::station {

/// The surface point at the image's middle pixel: on the ray of this pixel, at the median depth of the smallest centred
/// square (8, 16, 32, … px wide) of which at least half is measured. nullopt: no such square fits into the image.
[[nodiscard]] std::optional<Point<DepthCamera>> point_under_center(const DepthImage& depth, const Intrinsics& camera);

/// `haptic_from_camera` shifted, not turned, so that `skin` (a point of the patient's surface, such as the one under
/// the image centre) becomes the origin of the haptic base's frame H. A scene made for one camera height then works at
/// any height.
[[nodiscard]] Transform<HapticBase, DepthCamera> centered_on(
    const Transform<HapticBase, DepthCamera>& haptic_from_camera, const Point<DepthCamera>& skin) noexcept;

/// The scene's haptic_from_camera; with Scene::center_on_surface, shifted by centered_on() to the surface point of
/// point_under_center(). nullopt: that point is needed and is not measured.
[[nodiscard]] std::optional<Transform<HapticBase, DepthCamera>> placed(const scenes::Scene& scene,
                                                                       const DepthImage& depth,
                                                                       const Intrinsics& camera);

}  // namespace telepalp::station
