#include "server/voice/alsa/room_loudspeaker.h"

#include <utility>

#include "server/voice/alsa/pace.h"
#include "server/voice/alsa/pcm.h"

namespace telepalp::voice {

RoomLoudspeaker::RoomLoudspeaker(std::string device, const wire::SessionClock& clock,
                                 std::function<void(const std::string& problem)> on_problem)
    : device_(std::move(device)),
      clock_(clock),
      thread_(true,
              {.use = [this](DeviceThread& thread) { return play(thread); }, .on_problem = std::move(on_problem)}) {}

void RoomLoudspeaker::add(std::vector<codec::VoicePacket> packets) {
  const SessionTime now = clock_.now();
  const std::scoped_lock lock(mutex_);
  for (codec::VoicePacket& packet : packets) playout_.add(std::move(packet), now);
}

codec::VoicePlayout::Counts RoomLoudspeaker::counts() const {
  const std::scoped_lock lock(mutex_);
  return playout_.counts();
}

Result<void> RoomLoudspeaker::play(DeviceThread& thread) {
  Result<Pcm> opened = Pcm::open(device_, Pcm::Direction::Playback);
  if (!opened) return opened.error();
  Pcm pcm = std::move(opened).value();
  Pace pace;
  std::uint64_t broken = 0;
  while (thread.goes_on()) {
    codec::VoicePlayout::Played played;
    {
      const std::scoped_lock lock(mutex_);
      played = playout_.next(clock_.now());
    }
    pace.before_block();
    if (const Result<void> written = pcm.write(played.samples); !written) return written;
    thread.works();
    breaks_ += pcm.breaks() - std::exchange(broken, pcm.breaks());
    thread.sleep_until(pace.after_block());
  }
  return {};
}

}  // namespace telepalp::voice
