#include "server/voice/alsa/room_microphone.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "codec/voice.h"
#include "server/voice/alsa/pace.h"
#include "server/voice/alsa/pcm.h"

namespace telepalp::voice {
namespace {

/// The session time at which frame 0 began, from the times at which the newest frames were read: each was read at least
/// as late as it was spoken, so the earliest estimate of the last second counts.
class FrameZero {
 public:
  SessionTime add(SessionTime estimate) {
    estimates_[next_++ % kKept] = estimate;
    const std::size_t known = std::min(next_, kKept);
    return *std::min_element(estimates_.begin(), estimates_.begin() + static_cast<std::ptrdiff_t>(known));
  }

 private:
  static constexpr std::size_t kKept = 50;
  std::vector<SessionTime> estimates_ = std::vector<SessionTime>(kKept);
  std::size_t next_ = 0;
};

}  // namespace

RoomMicrophone::RoomMicrophone(std::string device, bool is_open, const wire::SessionClock& clock, Handlers handlers)
    : device_(std::move(device)),
      clock_(clock),
      started_(clock.now()),
      handlers_(std::move(handlers)),
      thread_(is_open, {.use = [this](DeviceThread& thread) { return capture(thread); },
                        .on_problem = [this](const std::string& problem) { handlers_.on_state(false, problem); }}) {}

std::uint32_t RoomMicrophone::frames_since_start() const {
  return static_cast<std::uint32_t>((clock_.now() - started_) / Nanoseconds(kVoiceFrameTime));
}

Result<void> RoomMicrophone::capture(DeviceThread& thread) {
  Result<Pcm> opened = Pcm::open(device_, Pcm::Direction::Capture);
  if (!opened) return opened.error();
  Pcm pcm = std::move(opened).value();
  codec::VoiceEncoder encoder;
  Pace pace;
  FrameZero zero;
  std::uint64_t broken = 0;
  std::uint32_t begun = next_ = std::max(next_, frames_since_start());
  bool told = false;
  Result<void> done;
  while (thread.goes_on()) {
    pace.before_block();
    const Result<codec::VoiceSamples> samples = pcm.read();
    if (!samples) {
      done = samples.error();
      break;
    }
    if (pcm.breaks() != std::exchange(broken, pcm.breaks())) {
      ++breaks_;
      begun = next_ = std::max(next_, frames_since_start());
      zero = {};
    }
    if (!std::exchange(told, true)) {
      thread.works();
      handlers_.on_state(true, "");
    }
    const Nanoseconds since_zero = std::int64_t{next_ + 1} * Nanoseconds(kVoiceFrameTime);
    const SessionTime frame_0 = zero.add(clock_.now() - pcm.read_delay() - since_zero);
    handlers_.on_heard({.number = next_,
                        .begun = begun,
                        .spoken = frame_0 + std::int64_t{next_} * Nanoseconds(kVoiceFrameTime),
                        .opus = encoder.encode(*samples)});
    ++next_;
    thread.sleep_until(pace.after_block());
  }
  if (done && told) handlers_.on_state(false, "");
  return done;
}

}  // namespace telepalp::voice
