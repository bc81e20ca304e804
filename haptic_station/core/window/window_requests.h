#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "haptic_station/core/window/hand_window.h"
#include "haptic_station/loop/tick_sample.h"
#include "messages/station.pb.h"

namespace telepalp::core {

/// Asks the server for the window of exact depth 30 times a second, from the ticks of the 2 kHz loop, and says in one
/// sentence when the hand outruns the window. Pure; owner: the network thread.
class WindowRequests {
 public:
  /// The request that is due after `tick`; nullopt: none is due, or the hand is not before the camera. It looks ahead
  /// by one and a half times the age of the surface, as a request travels up before an image comes down, and a frame.
  [[nodiscard]] std::optional<msg::WindowRequest> due(const loop::TickSample& tick,
                                                      const Transform<HapticBase, DepthCamera>& haptic_from_camera,
                                                      const Intrinsics& camera);

  /// The sentence for people when the hand has left the window, at most once in 5 s; nullopt: nothing new.
  [[nodiscard]] std::optional<std::string> look(const msg::SurfaceReport& report, SessionTime now);

 private:
  std::optional<loop::TickSample> last_;  // of the last request
  bool outside_ = false;
  std::optional<SessionTime> said_;
};

}  // namespace telepalp::core
