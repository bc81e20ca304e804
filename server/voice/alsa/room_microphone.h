#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "proto/wire/session_clock.h"
#include "server/voice/alsa/device_thread.h"

namespace telepalp::voice {

/// 20 ms of the room's sound, coded.
struct HeardFrame {
  std::uint32_t number = 0;  ///< one more for each 20 ms, also while the microphone is closed
  std::uint32_t begun = 0;   ///< number of the first frame since it was opened, or since sound was lost
  SessionTime spoken{};      ///< when its first sample was at the microphone
  std::string opus{};
};

/// The microphone in the patient's room. Its device is open only while the microphone is: a closed one has its own
/// light off, and other programs may use it. Captures and codes on a thread of its own.
class RoomMicrophone {
 public:
  struct Handlers {
    std::function<void(HeardFrame)> on_heard;                       ///< on the microphone's thread
    std::function<void(bool hears, std::string problem)> on_state;  ///< on the microphone's thread, at each change
  };
  RoomMicrophone(std::string device, bool is_open, const wire::SessionClock& clock, Handlers handlers);

  void open(bool is_open) { thread_.want(is_open); }
  void stop() { thread_.stop(); }
  [[nodiscard]] std::uint64_t breaks() const noexcept { return breaks_; }  ///< any thread

 private:
  Result<void> capture(DeviceThread& thread);
  [[nodiscard]] std::uint32_t frames_since_start() const;

  const std::string device_;
  const wire::SessionClock clock_;
  const SessionTime started_;
  Handlers handlers_;
  std::uint32_t next_ = 0;  // number of the next frame; the microphone's thread
  std::atomic<std::uint64_t> breaks_{0};
  DeviceThread thread_;  // last member: the thread uses the others
};

}  // namespace telepalp::voice
