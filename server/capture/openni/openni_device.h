#pragma once

#include <memory>
#include <string>

#include "proto/wire/session_clock.h"
#include "server/capture/openni/camera_device.h"

namespace telepalp::capture {

/// A live camera through OpenNI2: depth, and colour if the camera has it; aligned pixel by pixel if the driver supports
/// registration. `uri` empty: any connected camera. CameraDevice::open() connects to the camera.
[[nodiscard]] std::unique_ptr<CameraDevice> make_openni_device(std::string uri, wire::SessionClock clock);

}  // namespace telepalp::capture
