#pragma once

#include <optional>

#include "foxglove/CameraCalibration.pb.h"
#include "haptic_station/scenes/scene.h"
#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::station {

/// The surface point under the middle of the image: on the central ray, at the median depth of the smallest centred
/// window in which at least half of the pixels are measured. nullopt when no such window is within the image.
[[nodiscard]] std::optional<Point<DepthCamera>> point_under_center(const DepthImage& depth, const Intrinsics& camera);

/// `haptic_from_camera` shifted, not turned, so that `skin` (a point of the patient's surface, such as the one under
/// the image centre) becomes H's origin. A scene placed for one camera height then suits every other.
[[nodiscard]] Transform<HapticBase, DepthCamera> centered_on(
    const Transform<HapticBase, DepthCamera>& haptic_from_camera, const Point<DepthCamera>& skin) noexcept;

/// Where the scene lies before this camera: as it says, or centred on the skin that the camera sees. nullopt: it is to
/// be centred, and the middle of the image shows nothing.
[[nodiscard]] std::optional<Transform<HapticBase, DepthCamera>> placed(const scenes::Scene& scene,
                                                                       const DepthImage& depth,
                                                                       const Intrinsics& camera);

/// nullopt: not what a camera can be.
[[nodiscard]] std::optional<Intrinsics> intrinsics_of(const foxglove::CameraCalibration& calibration);

}  // namespace telepalp::station
