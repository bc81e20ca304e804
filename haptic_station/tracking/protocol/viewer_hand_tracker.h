#pragma once

#include "haptic_station/ports/tracker.h"
#include "haptic_station/tracking/hover/guided_hand.h"
#include "haptic_station/tracking/hover/skin_heights.h"
#include "haptic_station/tracking/protocol/latest_hand.h"
#include "messages/viewer.pb.h"
#include "proto/words/clock_envelope.h"

namespace telepalp::tracking {

/// A hand that a user moves in a viewer by mouse, finger or headset. The server sends the hand on /viewer/hand and
/// decides which viewer may move it. A viewer whose user lets go or hides the page, or whose connection is lost, sends
/// nothing; the station's watchdog then acts on the age of the last position. The hand that this tracker reports goes
/// the way of GuidedHand, from one viewer's hand to the next one's, too.
class ViewerHandTracker final : public ports::Tracker {
 public:
  using Clock = std::chrono::steady_clock;

  enum class Taken {
    Followed,
    /// Not followed yet: another viewer is followed, and was heard less than 0.3 s ago. Until that viewer has been
    /// silent for 0.3 s, no new hand is followed, so the station releases its force. Afterwards the station follows the
    /// new hand like a first hand, without a jump between the two hands' positions.
    Passing,
    OutOfReach,  ///< further than 0.5 m from the origin of the haptic base's frame
  };

  /// Takes a message received at `now`. `at`: its hand, in the haptic base's frame H. Network thread only.
  Taken hear(const msg::ViewerHand& hand, const Point<HapticBase>& at, Clock::time_point now) noexcept;

  /// Takes what the camera sees now. Surface thread only.
  void see(const SkinHeights& skin) { skin_.put(skin); }

  [[nodiscard]] std::optional<ports::HandSample> sample(SessionTime now,
                                                        const ports::DeviceReading& device) noexcept override {
    return sample_at(now, Clock::now(), device);
  }
  /// As sample(), for any clock. `steady`: the time on hear()'s clock when the session time is `now`.
  [[nodiscard]] std::optional<ports::HandSample> sample_at(SessionTime now, Clock::time_point steady,
                                                           const ports::DeviceReading& device) noexcept;

 private:
  std::uint64_t viewer_ = 0;     // owner: network thread; the viewer that is followed, 0: no viewer yet
  Clock::time_point heard_{};    // owner: network thread
  ClockEnvelope viewers_clock_;  // owner: network thread
  struct Hovers {
    bool hovers = false;
  };
  LatestHand<HapticBase, Hovers> latest_hand_;  // network thread to haptic thread
  LatestValue<SkinHeights> skin_;               // surface thread to haptic thread
  GuidedHand guided_;                           // owner: haptic thread
  std::optional<SessionTime> sampled_;          // owner: haptic thread; time of the newest sample
};

/// Describes the result in a log line.
[[nodiscard]] const char* in_words(ViewerHandTracker::Taken taken) noexcept;

}  // namespace telepalp::tracking
