#pragma once

#include <chrono>
#include <string>
#include <variant>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::server {

/// A camera that can come and go, as the reconnecting source sees it: OpenNI2 in the product, a script in tests.
class CameraDevice {
 public:
  /// A frame as the driver stamped it: `frame.captured` and `frame.sequence` are not set.
  struct Frame {
    RgbdFrame frame;
    std::chrono::microseconds driver_time{};
    SessionTime arrival;
  };
  struct Nothing {};  ///< none came within the patience
  struct Gone {
    std::string why;
  };
  struct Ended {};  ///< a recording came to its end
  using Read = std::variant<Nothing, Frame, Gone, Ended>;

  virtual ~CameraDevice() = default;

  /// Opens the device and starts its streams. After an error, and after close(), it may be called again.
  [[nodiscard]] virtual Result<void> open() = 0;
  [[nodiscard]] virtual Read read(Nanoseconds patience) = 0;
  virtual void close() = 0;

  /// For people: the device's name and what it delivers.
  [[nodiscard]] virtual std::string describe() const = 0;
};

}  // namespace telepalp::server
