#pragma once

#include <optional>

#include "foxglove/CameraCalibration.pb.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::wire {

/// Intrinsics [pixels] from a calibration message. nullopt: K is missing, or its size or numbers are impossible for a
/// camera.
[[nodiscard]] std::optional<Intrinsics> intrinsics_of(const foxglove::CameraCalibration& calibration);

}  // namespace telepalp::wire
