#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "codec/voice_playout.h"
#include "proto/wire/session_clock.h"
#include "server/voice/alsa/device_thread.h"

namespace telepalp::voice {

/// The loudspeaker in the patient's room, which plays what the doctor says. Its thread decodes and plays, and is silent
/// while nobody talks. A mutex guards the jitter buffer, because the network thread fills it; neither thread is
/// real-time.
class RoomLoudspeaker {
 public:
  /// `on_problem`: on the loudspeaker's thread, when there is another problem; empty: it plays.
  RoomLoudspeaker(std::string device, const wire::SessionClock& clock,
                  std::function<void(const std::string& problem)> on_problem);

  /// Packets that have come now. Any thread.
  void add(std::vector<codec::VoicePacket> packets);
  void stop() { thread_.stop(); }
  [[nodiscard]] codec::VoicePlayout::Counts counts() const;                ///< any thread
  [[nodiscard]] std::uint64_t breaks() const noexcept { return breaks_; }  ///< any thread

 private:
  Result<void> play(DeviceThread& thread);

  const std::string device_;
  const wire::SessionClock clock_;
  mutable std::mutex mutex_;  // guards playout_
  codec::VoicePlayout playout_;
  std::atomic<std::uint64_t> breaks_{0};
  DeviceThread thread_;  // last member: the thread uses the others
};

}  // namespace telepalp::voice
