#pragma once

#include <memory>
#include <string>

#include "proto/wire/session_clock.h"
#include "server/capture/camera_device.h"

namespace telepalp::server {

/// What to open with OpenNI2.
struct OpenNiAddress {
  std::string uri;         ///< empty: any connected camera; a path: a recording
  bool recording = false;  ///< both streams are started together
  bool loop = true;        ///< a recording starts over at its end
  bool paced = true;       ///< false: a recording's next frame comes when it is asked for, and none is dropped
};

/// A live camera or a recorded one through OpenNI2: depth, colour when there is one, registered when the driver can.
[[nodiscard]] std::unique_ptr<CameraDevice> make_openni_device(OpenNiAddress address, wire::SessionClock clock);

}  // namespace telepalp::server
