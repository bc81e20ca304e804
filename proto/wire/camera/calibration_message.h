#pragma once

#include <optional>

#include "foxglove/CameraCalibration.pb.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::wire {

/// Intrinsics [pixels] from a calibration message. nullopt: its camera matrix does not have nine numbers, or the
/// intrinsics are not well-formed (rgbd_frame.h: sides up to kMaxImageSide, finite numbers, positive focal lengths).
[[nodiscard]] std::optional<Intrinsics> intrinsics_of(const foxglove::CameraCalibration& calibration);

}  // namespace telepalp::wire
