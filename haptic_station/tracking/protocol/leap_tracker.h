#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <string>

#include "haptic_station/device/protocol/protocol_thread.h"
#include "haptic_station/device/protocol/websocket_line.h"
#include "haptic_station/ports/tracker.h"
#include "haptic_station/tracking/protocol/followed_hand.h"
#include "haptic_station/tracking/protocol/latest_hand.h"
#include "proto/words/clock_envelope.h"

namespace telepalp::tracking {

/// Default address of the Leap Motion service.
[[nodiscard]] inline device::WebSocketUrl standard_leap_url() { return {"127.0.0.1", 6437, "/v6.json"}; }

/// A Leap Motion hand tracker, read over the WebSocket of its service on a separate thread. It reconnects after a lost
/// connection. Until then no samples come, and the station's watchdog acts on the age of the last sample.
class LeapTracker final : public ports::Tracker {
 public:
  using Say = std::function<void(const std::string&)>;  ///< called on this tracker's thread

  LeapTracker(device::WebSocketUrl url, const Transform<HapticBase, HandTracker>& haptic_from_tracker, Say say);
  ~LeapTracker() override;

  /// Waits until the service announces protocol 6. Error: no announcement within `limit`.
  [[nodiscard]] Result<void> start(std::chrono::milliseconds limit);

  [[nodiscard]] std::optional<ports::HandSample> sample(SessionTime now,
                                                        const ports::DeviceReading& device) noexcept override;
  /// The newest palm position in the tracker's frame, for calibration; nullopt: none since the last call. It consumes
  /// the sample, so use either palm() or sample(). Haptic thread only.
  [[nodiscard]] std::optional<Point<HandTracker>> palm() noexcept;

  /// Number of texts and hands from the service that were refused as invalid.
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_.load(std::memory_order_relaxed); }

 private:
  using Clock = std::chrono::steady_clock;

  void on_text(std::string_view text);
  void on_hello(const leap::Hello& hello);
  void on_frame(const leap::Frame& frame);
  void refuse(const std::string& why);

  device::ProtocolThread thread_;
  const std::string name_;
  const Say say_;
  device::WebSocketLine line_;   // owner: thread_
  ClockEnvelope service_clock_;  // owner: thread_
  FollowedHand followed_;        // owner: thread_
  bool spoke_ = false;           // owner: thread_
  bool line_is_up_ = false;      // owner: thread_
  std::atomic<std::uint64_t> refused_{0};
  LatestHand<HandTracker> latest_hand_;  // thread_ to haptic thread
  const Transform<HapticBase, HandTracker> haptic_from_tracker_;
};

}  // namespace telepalp::tracking
