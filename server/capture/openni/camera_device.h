#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <variant>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "server/capture/exposure.h"

namespace telepalp::capture {

/// Interface of a camera that may be unplugged and plugged in again, used by ReconnectingSource. The server implements
/// it with OpenNI2, tests with a scripted device.
class CameraDevice {
 public:
  /// A frame with the driver's time stamp; `frame.captured` and `frame.sequence` are not set.
  struct Frame {
    RgbdFrame frame;
    std::chrono::microseconds driver_time{};
    SessionTime arrival;  ///< when the depth image arrived
  };
  struct Nothing {};  ///< no frame came within the `patience` of read()
  struct Gone {
    std::string why;  ///< text for the technician: why the device is lost
  };
  struct Ended {};  ///< the device plays a recording, and the recording has ended
  using Read = std::variant<Nothing, Frame, Gone, Ended>;

  virtual ~CameraDevice() = default;

  /// Opens the device and starts its streams. May be called again after an error or close().
  [[nodiscard]] virtual Result<void> open() = 0;
  [[nodiscard]] virtual Read read(Nanoseconds patience) = 0;
  virtual void close() = 0;

  /// As of CaptureSource. The device is open.
  [[nodiscard]] virtual std::optional<ExposureLimits> exposure_limits() { return std::nullopt; }
  [[nodiscard]] virtual Exposure exposure() { return {}; }
  /// False: the driver refuses it.
  [[nodiscard]] virtual bool set_exposure(const Exposure&) { return false; }

  /// Text for the technician: the device's name and its streams.
  [[nodiscard]] virtual std::string describe() const = 0;
};

}  // namespace telepalp::capture
