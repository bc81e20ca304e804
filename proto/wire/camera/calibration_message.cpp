#include "proto/wire/camera/calibration_message.h"

namespace telepalp::wire {

std::optional<Intrinsics> intrinsics_of(const foxglove::CameraCalibration& calibration) {
  if (calibration.k_size() != 9 || calibration.width() > kMaxImageSide || calibration.height() > kMaxImageSide)
    return std::nullopt;
  const Intrinsics camera{.width = static_cast<int>(calibration.width()),
                          .height = static_cast<int>(calibration.height()),
                          .fx = calibration.k(0),
                          .fy = calibration.k(4),
                          .cx = calibration.k(2),
                          .cy = calibration.k(5)};
  return is_well_formed(camera) ? std::optional(camera) : std::nullopt;
}

}  // namespace telepalp::wire
