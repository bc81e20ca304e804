#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "codec/voice.h"
#include "proto/words/result.h"

struct _snd_pcm;  // of ALSA, whose header has thousands of macros

namespace telepalp::voice {

/// A sound device of ALSA in one direction: one channel at 48 kHz, 20 ms at a time. ALSA converts what the hardware
/// has. When recorded sound was not read in time, or the loudspeaker ran out of sound, the device is started again;
/// this is counted. Owner: one thread.
class Pcm {
 public:
  enum class Direction { Capture, Playback };

  /// Opens `device`, a name of ALSA such as "default" or "hw:1,0". Error: it is not there, is used by another program,
  /// or cannot convert to this format.
  [[nodiscard]] static Result<Pcm> open(const std::string& device, Direction direction);

  /// The next 20 ms from the microphone. Waits at most a second for them. Error: the device is gone, or gives no sound.
  [[nodiscard]] Result<codec::VoiceSamples> read();
  /// Passes 20 ms to the loudspeaker. Waits at most a second until there is room. Error: as for read().
  [[nodiscard]] Result<void> write(const codec::VoiceSamples& samples);

  /// How long ago the newest sample that read() returned was at the microphone.
  [[nodiscard]] std::chrono::nanoseconds read_delay() const;
  /// How often recorded sound was lost, or the loudspeaker ran out of sound.
  [[nodiscard]] std::uint64_t breaks() const noexcept { return breaks_; }

 private:
  struct Close {
    void operator()(_snd_pcm* pcm) const noexcept;
  };
  Pcm(_snd_pcm* pcm, std::string device) : pcm_(pcm), device_(std::move(device)) {}
  template <class Transfer>
  [[nodiscard]] Result<void> transfer(Transfer part);
  [[nodiscard]] Error failed(int problem) const;

  std::unique_ptr<_snd_pcm, Close> pcm_;
  std::string device_;
  std::uint64_t breaks_ = 0;
};

}  // namespace telepalp::voice
