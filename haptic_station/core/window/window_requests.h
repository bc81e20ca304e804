#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "haptic_station/core/window/hand_window.h"
#include "haptic_station/loop/tick_sample.h"
#include "messages/station.pb.h"

namespace telepalp::core {

/// Makes the requests for the window of exact depth, 30 a second, from the ticks of the 2 kHz loop, and the sentence
/// for people when the hand leaves the window. Pure; owner: the network thread.
class WindowRequests {
 public:
  /// The request that is due after `tick`; nullopt: none is due, or the hand is not in front of the camera. The window
  /// holds for the time from a request to its image: one and a half times the age of the surface, because the request
  /// travels to the server before the image comes back, plus one frame period.
  [[nodiscard]] std::optional<msg::WindowRequest> due(const loop::TickSample& tick,
                                                      const Transform<HapticBase, DepthCamera>& haptic_from_camera,
                                                      const Intrinsics& camera);

  /// The sentence for people when the hand has left the window, at most once in 5 s; nullopt: nothing new.
  [[nodiscard]] std::optional<std::string> look(const msg::SurfaceReport& report, SessionTime now);

 private:
  std::optional<loop::TickSample> last_;  // at the last request
  bool outside_ = false;                  // in the newest report, the hand is outside the window
  std::optional<SessionTime> said_;       // when look() last returned a sentence
};

}  // namespace telepalp::core
