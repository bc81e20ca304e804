#include "server/voice/alsa/pcm.h"

#include <alsa/asoundlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace telepalp::voice {
namespace {

using namespace std::chrono_literals;
using Block = std::array<std::int16_t, kVoiceFrameSamples>;

constexpr unsigned kBuffer_us = 60'000;  // three frames: the scheduler of a busy machine may be late by one
constexpr int kLookEvery_ms = 100;
constexpr auto kPatience = 1s;
constexpr float kFullScale = 32'768.0F;

/// ALSA would write to stderr at each attempt to open a device that is not there.
void say_nothing(const char*, int, const char*, int, const char*, ...) {}

Error cannot_open(const std::string& device, int problem) {
  return {.what = std::string("the sound device cannot be opened: ") + snd_strerror(problem),
          .where = device,
          .fix =
              "connect it, end the program that uses it, or name another one: arecord -L lists microphones, aplay -L "
              "loudspeakers; the server's user must be in the group audio"};
}

}  // namespace

void Pcm::Close::operator()(snd_pcm_t* pcm) const noexcept {
  snd_pcm_drop(pcm);  // closing would wait until the loudspeaker has played all
  snd_pcm_close(pcm);
}

Result<Pcm> Pcm::open(const std::string& device, Direction direction) {
  snd_lib_error_set_handler(say_nothing);
  snd_pcm_t* opened = nullptr;
  const auto stream = direction == Direction::Capture ? SND_PCM_STREAM_CAPTURE : SND_PCM_STREAM_PLAYBACK;
  if (const int problem = snd_pcm_open(&opened, device.c_str(), stream, SND_PCM_NONBLOCK); problem < 0)
    return cannot_open(device, problem);
  Pcm pcm(opened, device);
  const int set = snd_pcm_set_params(opened, SND_PCM_FORMAT_S16, SND_PCM_ACCESS_RW_INTERLEAVED, 1,
                                     static_cast<unsigned>(kVoiceRate_hz), 1, kBuffer_us);
  if (set < 0) return cannot_open(device, set);
  if (direction == Direction::Capture)
    if (const int begun = snd_pcm_start(opened); begun < 0) return cannot_open(device, begun);
  return pcm;
}

Error Pcm::failed(int problem) const {
  return {.what = std::string("the sound device is gone: ") + snd_strerror(problem),
          .where = device_,
          .fix = "connect it again; the server tries again by itself"};
}

/// Calls `part(done)` with the number of samples transferred so far until all are. `part` returns as snd_pcm_readi
/// does.
template <class Transfer>
Result<void> Pcm::transfer(Transfer part) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  for (snd_pcm_uframes_t done = 0; done < kVoiceFrameSamples;) {
    const snd_pcm_sframes_t moved = part(done);
    if (moved > 0) {
      done += static_cast<snd_pcm_uframes_t>(moved);
      continue;
    }
    if (std::chrono::steady_clock::now() > deadline) return failed(-ETIMEDOUT);
    if (moved == 0 || moved == -EAGAIN) {
      if (const int ready = snd_pcm_wait(pcm_.get(), kLookEvery_ms); ready >= 0) continue;
    }
    const int problem = moved < 0 && moved != -EAGAIN ? static_cast<int>(moved) : -EPIPE;
    ++breaks_;
    if (const int recovered = snd_pcm_recover(pcm_.get(), problem, 1); recovered < 0) return failed(recovered);
    if (snd_pcm_stream(pcm_.get()) == SND_PCM_STREAM_CAPTURE)
      if (const int begun = snd_pcm_start(pcm_.get()); begun < 0) return failed(begun);
  }
  return {};
}

Result<codec::VoiceSamples> Pcm::read() {
  Block block{};
  const Result<void> got = transfer(
      [&](snd_pcm_uframes_t done) { return snd_pcm_readi(pcm_.get(), block.data() + done, block.size() - done); });
  if (!got) return got.error();
  codec::VoiceSamples samples;
  std::ranges::transform(block, samples.begin(), [](std::int16_t one) { return static_cast<float>(one) / kFullScale; });
  return samples;
}

Result<void> Pcm::write(const codec::VoiceSamples& samples) {
  Block block;
  std::ranges::transform(samples, block.begin(), [](float one) {
    return static_cast<std::int16_t>(std::lround(std::clamp(one * kFullScale, -kFullScale, kFullScale - 1.0F)));
  });
  return transfer(
      [&](snd_pcm_uframes_t done) { return snd_pcm_writei(pcm_.get(), block.data() + done, block.size() - done); });
}

std::chrono::nanoseconds Pcm::read_delay() const {
  snd_pcm_sframes_t waiting = 0;
  if (snd_pcm_delay(pcm_.get(), &waiting) < 0) return 0ns;
  const auto samples = std::clamp<snd_pcm_sframes_t>(waiting, 0, kVoiceRate_hz);
  return std::chrono::nanoseconds(std::int64_t{samples} * 1'000'000'000 / kVoiceRate_hz);
}

}  // namespace telepalp::voice
