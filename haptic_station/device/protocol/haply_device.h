#pragma once

#include <atomic>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "haptic_station/device/protocol/haply_inverse.h"
#include "haptic_station/device/protocol/protocol_thread.h"
#include "haptic_station/device/protocol/websocket_line.h"
#include "haptic_station/ports/device.h"
#include "proto/words/latest_value.h"

namespace telepalp::device {

/// Default address of the Haply Inverse service.
[[nodiscard]] inline WebSocketUrl standard_haply_url() { return {"127.0.0.1", 10001, "/"}; }

/// Middle of an Inverse3's workspace, in the Inverse3's frame [m]. The origin of the haptic base's frame H, a point of
/// the skin, is at this middle.
[[nodiscard]] inline Point<haply::InverseBase> middle_of_inverse3() { return {{0.04, -0.17, 0.16}}; }

/// A Haply Inverse3 with or without a handle (VerseGrip), which measures the attitude: six degrees of freedom measured,
/// three driven. At the identity, the handle's axes are those of the Inverse3, with its z as y of H. Driven over the
/// WebSocket of its service on a separate thread. Each text message from the service is answered with the newest force,
/// at most 2500 times a second. A force that the haptic thread has not renewed for 50 ms is replaced by zero. The
/// service answers each text with a text of its own, so each reading answers the force that was sent before it.
class HaplyDevice final : public ports::Device {
 public:
  using Say = std::function<void(const std::string&)>;  ///< gets a message for the operator, on this device's thread

  HaplyDevice(WebSocketUrl url, const Point<haply::InverseBase>& origin, Say say);
  ~HaplyDevice() override;

  /// Waits for the first position of a device. Error: no position came within `limit`.
  [[nodiscard]] Result<void> start(std::chrono::milliseconds limit);

  [[nodiscard]] ports::DeviceReading read() noexcept override;
  void apply(const Wrench<HapticBase>& wrench, const ports::SurfaceContact& contact, double dt_s) noexcept override;

  /// Number of invalid text messages received so far.
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_.load(std::memory_order_relaxed); }

 private:
  using Clock = std::chrono::steady_clock;
  struct TimedReading {
    Clock::time_point at;
    ports::DeviceReading reading;
    std::optional<Clock::time_point> echoes;  ///< when the haptic thread gave the force that this reading answers
  };
  struct Wanted {
    Clock::time_point at;
    Force<HapticBase> force;
  };

  void on_text(std::string_view text);
  [[nodiscard]] std::optional<Eigen::Quaterniond> newest_attitude() const;
  void answer();
  void send_force();

  ProtocolThread thread_;
  const std::string name_;
  const Say say_;
  const Transform<HapticBase, haply::InverseBase> haptic_from_inverse_;
  const Transform<haply::InverseBase, HapticBase> inverse_from_haptic_;
  boost::asio::steady_timer pace_;             // owner: thread_
  WebSocketLine line_;                         // owner: thread_
  std::string device_id_;                      // owner: thread_; the first device seen; later ones are ignored
  Clock::time_point sent_;                     // owner: thread_
  std::optional<Clock::time_point> answered_;  // owner: thread_; when the haptic thread gave the force of the newest
                                               // text; nullopt: its force is zero
  std::optional<std::pair<Clock::time_point, Eigen::Quaterniond>> attitude_;  // owner: thread_; of the handle
  std::pair<Clock::time_point, bool> pressed_{};                              // owner: thread_; the handle's button
  bool line_is_up_ = false;                                                   // owner: thread_
  std::atomic<std::uint64_t> refused_{0};
  LatestValue<TimedReading> readings_;  // thread_ to haptic thread
  LatestValue<Wanted> wanted_;          // haptic thread to thread_
  bool has_reading_ = false;            // owner: haptic thread
};

}  // namespace telepalp::device
