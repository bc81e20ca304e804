#pragma once

#include "haptic_station/ports/tracker.h"
#include "haptic_station/tracking/protocol/clock_envelope.h"
#include "haptic_station/tracking/protocol/hand_sightings.h"
#include "messages/viewer.pb.h"

namespace telepalp::tracking {

/// The hand that a person moves in a viewer, by mouse, finger or headset; the server forwards it on the topic
/// /viewer/hand. When the person lets go, hides the page or loses the connection, the messages stop, and the station's
/// watchdog acts on the age of the last one.
class BrowserHand final : public ports::Tracker {
 public:
  using Clock = std::chrono::steady_clock;

  enum class Taken {
    Followed,
    OtherViewer,  ///< ignored: another viewer has moved its hand within the last 0.3 s
    OutOfReach,   ///< ignored: farther than 0.5 m from the haptic base's origin
  };

  /// Takes a message received at `now`. `at`: its hand, in the haptic base's frame H. Network thread only.
  Taken hear(const msg::ViewerHand& hand, const Point<HapticBase>& at, Clock::time_point now) noexcept;

  [[nodiscard]] std::optional<ports::HandSample> sample(SessionTime now,
                                                        const ports::DeviceReading& device) noexcept override;

 private:
  std::uint64_t viewer_ = 0;         // owner: network thread; the viewer that is followed, 0: no viewer yet
  Clock::time_point heard_{};        // owner: network thread
  ClockEnvelope viewers_clock_;      // owner: network thread
  Sightings<HapticBase> sightings_;  // network thread to haptic thread
};

/// Describes the result in a log line.
[[nodiscard]] const char* in_words(BrowserHand::Taken taken) noexcept;

}  // namespace telepalp::tracking
