#pragma once

#include "haptic_station/ports/tracker.h"
#include "haptic_station/tracking/protocol/hand_sightings.h"
#include "messages/viewer.pb.h"
#include "proto/words/clock_envelope.h"

namespace telepalp::tracking {

/// A hand that somebody holds in a viewer, by mouse, finger or headset, as the server tells of it on /viewer/hand. The
/// server decides which viewer holds it. A viewer that lets go, rests or loses the line falls silent, and the station's
/// watchdog sees the age.
class BrowserHand final : public ports::Tracker {
 public:
  using Clock = std::chrono::steady_clock;

  enum class Taken {
    Followed,
    /// The hand passed from one viewer to another less than 0.3 s ago. Nothing is followed for that time: the station
    /// lets go, and takes up the new hand as it takes up a first one, without a step from one place to the other.
    Passing,
    OutOfReach,  ///< further than 0.5 m from H's origin
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
