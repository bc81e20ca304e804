#pragma once

#include "haptic_station/ports/tracker.h"
#include "haptic_station/tracking/protocol/clock_envelope.h"
#include "haptic_station/tracking/protocol/hand_sightings.h"
#include "messages/viewer.pb.h"

namespace telepalp::tracking {

/// A hand that somebody holds in a viewer, by mouse, finger or headset, as the server tells of it on /viewer/hand. Who
/// lets go, hides the page or loses the line falls silent, and the station's watchdog sees the age.
class BrowserHand final : public ports::Tracker {
 public:
  using Clock = std::chrono::steady_clock;

  enum class Taken {
    Followed,
    OtherViewer,  ///< a viewer's hand is followed until it has been silent for 0.3 s
    OutOfReach,   ///< further than 0.5 m from H's origin
  };

  /// A message heard at `now`, and where its hand is in H. Network thread only.
  Taken hear(const msg::ViewerHand& hand, const Point<HapticBase>& at, Clock::time_point now) noexcept;

  [[nodiscard]] std::optional<ports::HandSample> sample(SessionTime now,
                                                        const ports::DeviceReading& device) noexcept override;

 private:
  std::uint64_t viewer_ = 0;         // owner: network thread; 0: nobody yet
  Clock::time_point heard_{};        // owner: network thread
  ClockEnvelope viewers_clock_;      // owner: network thread
  Sightings<HapticBase> sightings_;  // network thread to haptic thread
};

/// For people.
[[nodiscard]] const char* in_words(BrowserHand::Taken taken) noexcept;

}  // namespace telepalp::tracking
